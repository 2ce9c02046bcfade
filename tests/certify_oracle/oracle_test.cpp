#include "certify/oracle/oracle.hpp"

#include <gmock/gmock.h>

#include <map>

#include "bezier/orientation.hpp"
#include "certify/checker/check_truth.hpp"
#include "certify/oracle/build_tree.hpp"
#include "certify/oracle/find_contact.hpp"
#include "certify/oracle/find_plane.hpp"
#include "files/case_json.hpp"
#include "mixed_cases.hpp"
#include "share.hpp"

namespace ccdfuzz {
namespace {

/// What of a case's own truth the decision contradicts; empty if nothing.
std::string contradiction(const Case& known, const Truth& found) {
  const auto by = known.truth.contact_by();
  const Rational t_max = exact(known.query.t_max);
  if (by && *by <= t_max && found.collides == false) return "a miss, but there is a contact";
  if (by && found.clear_until && *found.clear_until > *by) return "clear for too long";
  if (known.truth.collides == false && found.collides == true) return "a hit, but there is none";
  if (known.truth.clear_until && found.contact_by() &&
      *found.contact_by() < *known.truth.clear_until) {
    return "a contact too early";
  }
  return "";
}

constexpr int kMixedOfEach = kOneIn == 1 ? 2 : 1;

TEST(Oracle, DecidesMixedCasesInAgreementWithTheirTruth) {
  std::map<std::string, int> count;
  for_each_mixed_case(kMixedOfEach, 1, [&](const MixedCase& c) {
    Decision decision;
    ASSERT_NO_THROW(decision = decide(c.value.query)) << c.name << "\n" << to_json(c.value);
    const Truth& truth = decision.truth;
    EXPECT_EQ(contradiction(c.value, truth), "") << c.name << "\n" << to_json(c.value);
    if (c.transversal) {
      EXPECT_TRUE(truth.collides) << c.name << ": " << decision.note << "\n" << to_json(c.value);
    }
    if (c.value.truth.collides) {
      ++count[truth.collides ? "known and decided" : "known and undecided"];
    }
    ++count[!truth.collides ? "undecided" : *truth.collides ? "hit" : "miss"];
    if (truth.witness) ++count["W"];
    if (truth.contact_box) ++count["M"];
    if (truth.clearance) ++count[std::string(proof_word(*truth.clearance))];
  });
  // Every certificate is in use, and what the generator proves the oracle nearly always proves too.
  for (const char* kind : {"hit", "miss", "W", "M", "T", "P"})
    EXPECT_GE(count[kind], 4 * kMixedOfEach) << kind;
  EXPECT_GE(count["known and decided"], 9 * count["known and undecided"]);
}

TEST(Oracle, BracketsACrossingClosely) {
  RandomQueries random(3);
  int brackets = 0;
  for (int i = 0; i < 60; ++i) {
    const Query query = random.query(3, true);
    const Truth truth = decide(query).truth;
    if (truth.collides != true || !truth.clear_until) continue;
    ++brackets;
    EXPECT_LT(*truth.clear_until, *truth.contact_by());
    EXPECT_LT(Rational(*truth.contact_by() - *truth.clear_until), exact(query.t_max * 0x1p-10))
        << to_json({query, truth, {}, {}});
  }
  EXPECT_GE(brackets, 3);
}

TEST(Oracle, SaysTheSameAgain) {
  RandomQueries random(5);
  for (int i = 0; i < 20; ++i) {
    const Query query = i % 2 == 0 ? random.lattice() : random.query(3, true);
    const Decision first = decide(query), second = decide(query);
    EXPECT_EQ(first.truth, second.truth) << to_json({query, {}, {}, {}});
    EXPECT_EQ(first.tree, second.tree) << to_json({query, {}, {}, {}});
  }
}

TEST(Oracle, IsUndecidedWithinTooSmallABudget) {
  GeneratorOptions o;
  o.contact = ContactClass::kFF, o.kind = CaseKind::kRN;
  const Case known = generate(o, 0).value;
  OracleOptions options;
  options.max_pops = 3;
  options.max_tree_nodes = 3;
  const Decision decision = decide(known.query, options);
  EXPECT_EQ(decision.truth.collides, std::nullopt);
  EXPECT_NE(decision.note, "");
}

TEST(Oracle, AnswersAsAMethod) {
  GeneratorOptions o;
  o.contact = ContactClass::kVF;
  Oracle oracle;
  const Case positive = generate(o, 0).value;
  const Answer hit = oracle.answer(positive.query, {});
  EXPECT_EQ(hit.verdict, Verdict::kHit);
  EXPECT_LE(exact(*hit.toi), positive.truth.witness->t);
  o.kind = CaseKind::kRN;
  EXPECT_EQ(oracle.answer(generate(o, 0).value.query, {}).verdict, Verdict::kMiss);
}

/// Static patches that touch: the contact is there at once.
TEST(Oracle, FindsContactsAtTheBeginning) {
  Query query;
  const Vec3<double> o = {0, 0, 0};
  query.patches[0] = {Shape::triangle(1), {{-1, -1, 0}, {-1, 3, 0}, {3, -1, 0}}, {o, o, o}};
  query.patches[1] = {Shape::curve(1), {{0.1, 0.2, -1}, {0.3, 0.1, 1.25}}, {o, o}};
  for (const double t_max : {0.0, 1.0}) {
    query.t_max = t_max;
    const Truth truth = decide(query).truth;
    EXPECT_EQ(truth.collides, true);
    EXPECT_EQ(*truth.contact_by(), 0);
  }
  query.patches[1].positions[1] = {0.3, 0.1, -0x1p-30};
  EXPECT_EQ(decide(query).truth.collides, false);
}

// The parameters have 53 bits, and no box about them is inside of the region.
TEST(Oracle, FindsContactsOnSlantedEdgesOfTrims) {
  const Vec3<double> o = {0, 0, 0};
  for (const auto& [u, v, du, dv] : {std::array{0.3, 0.4, 0x1p-3, -0x1p-4},
                                     {0.3, 0.4, 0x1p-5, 0x1p-6},
                                     {0.7, 0.1, -0x1p-7, 0x1p-6}}) {
    for (const double share : {1.0, 0.5}) {
      const std::array<Uv<double>, 2> edge = {Uv<double>{u - du, v - dv},
                                              {u + share * du, v + share * dv}};
      ASSERT_EQ(orientation(edge[0], edge[1], {u, v}), 0);
      Query query;
      query.patches[0] = {Shape::triangle(1), {{0, 0, 0}, {0, 1, 0}, {1, 0, 0}}, {o, o, o}};
      query.patches[0].trim = {{edge[0], edge[1], {0, 0}}};
      query.patches[1] = {Shape::point(), {{u, v, 1}}, {{0, 0, -1}}};
      const Truth truth = decide(query).truth;
      ASSERT_EQ(truth.collides, true) << u << " " << v << " " << share;
      EXPECT_EQ(truth.witness->t, 1);
      EXPECT_EQ(truth.witness->uv[0], (Uv<Rational>{exact(u), exact(v)}));
    }
  }
}

/// A wavy patch at rest, its control points this much higher.
MovingPatch<double> wavy(double height) {
  MovingPatch<double> patch{Shape::tensor(8, 8), {}, Points<double>(81, {0, 0, 0})};
  for (int i = 0; i <= 8; ++i) {
    for (int j = 0; j <= 8; ++j) {
      const bool inside = 0 < i && i < 8 && 0 < j && j < 8;
      const double wave = inside ? ((i * i * 7 + j * 5) % 16 - 8) / 32.0 : 0;
      patch.positions.push_back({i / 8.0, j / 8.0, wave + height});
    }
  }
  return patch;
}

TEST(Oracle, LeavesUndecidedWhatTakesTheCheckerTooLong) {
  OracleOptions options;
  options.max_pops = 71'000;
  const Decision decision = decide({{wavy(0), wavy(0x1p-9)}, 1}, options);
  EXPECT_FALSE(decision.truth.collides);
  EXPECT_FALSE(decision.truth.clearance);
  EXPECT_NE(decision.note.find("exceeds the work budget"), std::string::npos) << decision.note;
}

}  // namespace
}  // namespace ccdfuzz
