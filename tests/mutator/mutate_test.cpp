#include "fuzz/mutator/mutate.hpp"

#include <gtest/gtest.h>

#include <map>

#include "bases.hpp"
#include "certify/checker/check_witness.hpp"
#include "files/case_json.hpp"
#include "fuzz/mutator/moves.hpp"
#include "share.hpp"

namespace ccdfuzz {
namespace {

/// What is wrong with q; empty if it is consistent.
std::string complaint_about(const Contact& q) {
  const Case made = case_of(q);
  if (const auto fault = fault_of(q.query)) return fault->message();
  if (q.t.sign() < 0 || made.truth.witness->t > exact(q.query.t_max)) {
    return "the contact is at " + to_text(made.truth.witness->t);
  }
  const auto checked = check_witness(q.query, *made.truth.witness);
  return checked ? "" : checked.error().message();
}

TEST(Mutate, EveryMoveKeepsTheContactAndIsOftenPossible) {
  const std::vector<Contact> bases = mutation_bases();
  std::map<std::string_view, int> made;
  Draw random{Random::keyed({6})};
  for (const Move& move : moves()) {
    SCOPED_TRACE(move.name);
    for (std::size_t i = 0; i < 600 / kOneIn; ++i) {
      const size_t base = random.below(bases.size()), other = random.below(bases.size());
      Contact q = bases[base];
      if (!move.apply(q, bases[other], random)) continue;
      ++made[move.name];
      ASSERT_EQ(complaint_about(q), "")
          << to_json(case_of(q)) << "\nfrom " << to_json(case_of(bases[base]));
    }
    EXPECT_GE(made[move.name], static_cast<int>(60 / kOneIn));
  }
}

TEST(Mutate, ChainsOfMutantsStayWholeAndGoAstray) {
  const std::vector<Contact> bases = mutation_bases();
  Draw random{Random::keyed({7})};
  size_t changed = 0, reshaped = 0;
  constexpr std::size_t kChains = 100 / kOneIn, kLength = 20;
  for (std::size_t chain = 0; chain < kChains; ++chain) {
    const Contact& base = bases[random.below(bases.size())];
    Contact q = base;
    for (std::size_t i = 0; i < kLength; ++i) {
      const Contact next = mutate(q, bases[random.below(bases.size())], random);
      changed += next.query == q.query ? 0 : 1;
      q = next;
      ASSERT_EQ(complaint_about(q), "") << to_json(case_of(q));
    }
    reshaped += q.query.patches[0].shape == base.query.patches[0].shape ? 0 : 1;
  }
  EXPECT_GE(changed, kChains * kLength * 9 / 10);
  EXPECT_GE(reshaped, kChains / 4);
}

// One number for all compilers: no draw may depend on the order in which they evaluate arguments.
// It changes with the moves, and only with them: put in the new one when you mean to change them.
TEST(Mutate, MakesTheSameMutantsEverywhere) {
  const std::vector<Contact> bases = mutation_bases();
  std::uint64_t hash = 0xcbf29ce484222325;  // FNV-1a
  Draw random{Random::keyed({9})};
  for (int i = 0; i < 60; ++i) {
    const Contact& q = bases[random.below(bases.size())];
    const Contact& other = bases[random.below(bases.size())];
    for (const char c : to_json(case_of(mutate(q, other, random)))) {
      hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
    }
  }
  EXPECT_EQ(hash, 0xfd5f37e80c52e0c4u) << std::hex << "0x" << hash;
}

TEST(Contact, IsMadeOfCasesWithADyadicWitnessWithinTheHorizon) {
  Draw random{Random::keyed({8})};
  const Case known = planted_case(ContactClass::kEF, random);
  const auto q = contact_of(known);
  ASSERT_TRUE(q);
  EXPECT_EQ(case_of(*q).truth.witness, known.truth.witness);
  Case early = known;
  early.query.t_max = 0x1p-10;
  EXPECT_FALSE(contact_of(early));
  Case third = known;
  third.truth.witness->uv[0][0] = Rational(1, 3);
  EXPECT_FALSE(contact_of(third));
  EXPECT_EQ(near_contact_of(third)->uv[0][0], Dyadic(Integer(10), -5));
  third.query.patches[1] = {Shape::triangle(1), {{}, {}, {}}, {{}, {}, {}}};
  third.truth.witness->uv[1] = {Rational(1, 100), Rational(197, 200)};
  EXPECT_FALSE(near_contact_of(third)) << "1/32 and 31/32 are on an edge";
}

}  // namespace
}  // namespace ccdfuzz
