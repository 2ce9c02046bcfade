#include "fuzz/mutator/case_bytes.hpp"

#include <gtest/gtest.h>

#include "bases.hpp"
#include "certify/checker/check_witness.hpp"
#include "files/case_json.hpp"
#include "share.hpp"

namespace ccdfuzz {
namespace {

TEST(CaseBytes, GiveTheSameQueryAgain) {
  for (const Contact& q : mutation_bases()) {
    const auto bytes = to_bytes(q);
    ASSERT_TRUE(bytes) << to_json(case_of(q));
    const auto again = contact_of_bytes(*bytes);
    ASSERT_TRUE(again) << to_json(case_of(q));
    EXPECT_EQ(case_of(*again), case_of(q));
  }
}

TEST(CaseBytes, BeginWithTheMethodWhichChangesNoQuery) {
  const Contact q = mutation_bases().front();
  for (const int method : {0, 1, 200, 255}) {
    const auto bytes = to_bytes(q, static_cast<std::uint8_t>(method)).value();
    EXPECT_EQ(bytes[0], method);
    EXPECT_EQ(method_number(bytes), method);
    EXPECT_EQ(contact_of_bytes(bytes)->query, q.query);
    EXPECT_EQ(query_of(bytes), q.query);
    EXPECT_EQ(cases_of(bytes), std::vector{case_of(q)});
  }
  EXPECT_EQ(method_number({}), 0);
}

TEST(CaseBytes, AreMadeWholeOrRefusedWhateverWasDoneToThem) {
  const std::vector<Contact> bases = mutation_bases();
  Draw random{Random(3)};
  size_t whole = 0;
  constexpr std::size_t kTries = 4000 / kOneIn;
  for (std::size_t i = 0; i < kTries; ++i) {
    std::vector<std::uint8_t> bytes = to_bytes(bases[random.below(bases.size())]).value();
    for (std::uint64_t left = random.below(4); left > 0; --left) {
      bytes[random.below(bytes.size())] ^= static_cast<std::uint8_t>(1U << random.below(8));
    }
    if (random.below(8) == 0) bytes.resize(random.below(bytes.size()));
    const auto q = contact_of_bytes(bytes);
    if (!q) continue;
    ++whole;
    const Case made = case_of(*q);
    ASSERT_TRUE(check_witness(made.query, *made.truth.witness)) << to_json(made);
  }
  EXPECT_GE(whole, kTries / 4);
  EXPECT_FALSE(contact_of_bytes({}));
}

TEST(CaseBytes, ABrokenContactIsShownAsItStandsAndMadeWhole) {
  const Contact q = mutation_bases().front();
  std::vector<std::uint8_t> bytes = to_bytes(q).value();
  const std::vector<Case> sound = cases_of(bytes);
  ASSERT_EQ(sound.size(), 1U);
  EXPECT_EQ(sound[0], case_of(q));
  bytes.back() ^= 1;  // the sign and exponent of the last velocity
  const std::vector<Case> broken = cases_of(bytes);
  ASSERT_EQ(broken.size(), 2U);
  EXPECT_EQ(broken[0].query, query_of(bytes).value());
  EXPECT_FALSE(broken[0].truth.witness);
  EXPECT_TRUE(check_witness(broken[1].query, *broken[1].truth.witness)) << to_json(broken[1]);
  EXPECT_TRUE(cases_of({}).empty());
}

TEST(CaseBytes, AreNoneWhenTheTimeIsNoDouble) {
  Contact q = mutation_bases().front();
  q.t = Dyadic(1) + Dyadic(Integer(1), -60);
  EXPECT_FALSE(to_bytes(q));
}

}  // namespace
}  // namespace ccdfuzz
