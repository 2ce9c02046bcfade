#include "ccd/tdibm.hpp"

#include <gtest/gtest.h>

#include "named_queries.hpp"
#include "planted.hpp"
#include "share.hpp"

namespace ccdfuzz {
namespace {

SearchOptions with_precision(double precision) {
  SearchOptions options;
  options.precision = precision;
  return options;
}

std::string describe(const Shape& a, const Shape& b, std::size_t index) {
  return to_text(a) + " " + to_text(b) + " #" + std::to_string(index);
}

/// Calls claim(query, witness, description) on a few planted contacts for every pair of shapes.
template <class Claim>
void for_planted_contacts(Claim&& claim) {
  for (const Shape& a : kSomeShapes) {
    for (const Shape& b : kSomeShapes) {
      for (std::size_t index = 0; index < 3; index += kOneIn) {
        Draw random{Random::keyed({static_cast<std::uint64_t>(a.control_count()),
                                   static_cast<std::uint64_t>(b.control_count()),
                                   static_cast<std::uint64_t>(index)})};
        const Planted planted = plant_contact(random, a, b);
        claim(planted.query, planted.witness, describe(a, b, index));
      }
    }
  }
}

TEST(Tdibm, PulledApartEnvelopesFindPlantedContacts) {
  Tdibm<PullApart> absolute(PullApart(1e-12, PullUnit::kLength));
  Tdibm<PullApart> relative(PullApart(1e-12));
  for_planted_contacts([&](const Query& query, const Witness& witness, const std::string& what) {
    for (const Answer& answer : {absolute.answer(query, with_precision(1e-3)),
                                 relative.answer(query, with_precision(1e-3))}) {
      EXPECT_EQ(answer.verdict, Verdict::kHit) << what;
      // Nothing of it claims to be in time to the last bit.
      EXPECT_LE(exact(answer.toi.value_or(2)), witness.t + power_of_two(-40)) << what;
    }
  });
}

TEST(Tdibm, HighestDegreesAreAnswered) {
  Draw random{Random::keyed({8})};
  const Planted planted = plant_contact(random, Shape::tensor(8, 8), Shape::triangle(8));
  Tdibm<ErrorBoundIntended> method;
  const Answer answer = method.answer(planted.query, with_precision(1e-2));
  ASSERT_EQ(answer.verdict, Verdict::kHit);
  EXPECT_LE(exact(answer.toi.value()), planted.witness.t);
}

TEST(TwinShield, PlainAndIntendedErrorBoundReportTheContact) {
  const Query query = twin_shield();
  Tdibm<Plain> plain;
  Tdibm<ErrorBoundIntended> error_bound;
  for (const Answer& answer : {plain.answer(query, with_precision(1e-2)),
                               error_bound.answer(query, with_precision(1e-2))}) {
    EXPECT_EQ(answer.verdict, Verdict::kHit);
    EXPECT_NEAR(answer.toi.value_or(-1), .742, .001);
  }
}

TEST(TwinShield, PrintedSignMissesTheContact) {
  Tdibm<ErrorBoundPrinted> printed;
  EXPECT_EQ(printed.answer(twin_shield(), with_precision(1e-2)).verdict, Verdict::kMiss);
}

}  // namespace
}  // namespace ccdfuzz
