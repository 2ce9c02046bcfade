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

TEST(Tdibm, ErrorBoundFindsPlantedContactsOfAllShapesInTime) {
  Tdibm<ErrorBoundIntended> method;
  for_planted_contacts([&](const Query& query, const Witness& witness, const std::string& what) {
    const Answer answer = method.answer(query, with_precision(1e-3));
    ASSERT_EQ(answer.verdict, Verdict::kHit) << what;
    ASSERT_LE(exact(answer.toi.value()), witness.t) << what;
    for (int side = 0; side < 2; ++side) {
      // The centre of a triangle's cell is rounded.
      const Uv<double>& uv = answer.uv[side];
      EXPECT_TRUE(0 <= uv[0] && uv[0] <= 1 && 0 <= uv[1] && uv[1] <= 1) << what;
    }
  });
}

/// True iff the contact persists under small changes and reaches into the cells around it: inside
/// both domains, with more unknowns than equations. (The parameters are dyadic, so an isolated
/// contact would lie at the corner of every cell that has it.)
bool is_stable(const Query& query, const Witness& witness) {
  int unknowns = 1;
  for (int side = 0; side < 2; ++side) {
    const Shape& shape = query.patches[side].shape;
    const Uv<Rational>& uv = witness.uv[side];
    for (int k = 0; k < shape.parameter_count(); ++k) {
      if (uv[k] <= 0 || uv[k] >= 1) return false;
    }
    if (shape.kind == ShapeKind::kTriangle && uv[0] + uv[1] >= 1) return false;
    unknowns += shape.parameter_count();
  }
  return unknowns >= 4;
}

TEST(Tdibm, PlainFindsStableContactsOfAllShapes) {
  Tdibm<Plain> method;
  int stable = 0;
  for_planted_contacts([&](const Query& query, const Witness& witness, const std::string& what) {
    if (!is_stable(query, witness)) return;
    ++stable;
    EXPECT_EQ(method.answer(query, with_precision(1e-3)).verdict, Verdict::kHit) << what;
  });
  EXPECT_GT(stable, kOneIn == 1 ? 5 : 1);
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

TEST(Tdibm, AllShapesMissWhenPatchesPartForGood) {
  Tdibm<Plain> plain;
  Tdibm<ErrorBoundIntended> error_bound;
  for_planted_contacts([&](Query query, const Witness&, const std::string& what) {
    for (size_t i = 0; i < query.patches[1].positions.size(); ++i) {
      query.patches[1].positions[i][2] += 64;  // no control point is farther from another
    }
    EXPECT_EQ(plain.answer(query, with_precision(1e-3)).verdict, Verdict::kMiss) << what;
    EXPECT_EQ(error_bound.answer(query, with_precision(1e-3)).verdict, Verdict::kMiss) << what;
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

TEST(Tdibm, AnObjectKeepsNothingBetweenQueries) {
  Draw random{Random::keyed({3})};
  const Query first = plant_contact(random, Shape::triangle(2), Shape::triangle(2)).query;
  const Query second = plant_contact(random, Shape::tensor(2, 2), Shape::curve(3)).query;
  Tdibm<ErrorBoundIntended> reused;
  const Answer before = reused.answer(first, with_precision(1e-3));
  reused.answer(second, with_precision(1e-3));
  const Answer after = reused.answer(first, with_precision(1e-3));
  EXPECT_EQ(before.toi, after.toi);
  EXPECT_EQ(before.pops, after.pops);
  EXPECT_EQ(before.uv, after.uv);
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
