#include <cmath>
#include <utility>

#include "case/scale.hpp"
#include "certify/checker/check_plane.hpp"
#include "certify/checker/check_tree.hpp"
#include "certify/checker/check_truth.hpp"
#include "certify/oracle/build_tree.hpp"
#include "certify/oracle/decide_linear.hpp"
#include "certify/oracle/find_plane.hpp"
#include "generators/round.hpp"
#include "method/method.hpp"
#include "properties/against_oracle.hpp"
#include "properties/answers.hpp"
#include "properties/draw_first_contact.hpp"
#include "properties/draw_linear.hpp"
#include "properties/query_kind.hpp"
#include "properties/show.hpp"

namespace ccdfuzz {

namespace {

Case draw_case_apart(Draw& d) {
  return case_of(draw_first_contact(d, true));
}

void check_not_early_apart(Draw& d) {
  const FirstContact drawn = draw_first_contact(d, true);
  // The first is the faster, and its axes are made for distances.
  constexpr SearchOptions kBrief = {kFinePrecision, 300, SearchOptions().max_bytes};
  claim_not_early(d.pick(std::array{"tdibm-c", "tdibm-c", "tdibm-rational"}), drawn, d, kBrief);
}

/// A tree that proves a share of a distance is refused as a proof of all of it, also of patches
/// that are round.
void check_trees(Draw& d) {
  const bool is_round = d.coin();
  const ContactClass contact = d.pick(std::array{ContactClass::kVF, ContactClass::kFF});
  const Case drawn = is_round ? draw_round_case(contact, true, d) : draw_case_apart(d);
  const Rational& t = drawn.truth.witness->t;
  Query nearer = drawn.query;
  nearer.separation *= d.pick(std::array{0.0, 0.5, 1 - 0x1p-6, 1 - 0x1p-20});
  show(d, "query", drawn.query);
  show(d, "separation", nearer.separation);
  const auto tree = supposed(build_miss_tree(nearer, t, is_round ? 3000 : 1000));
  CLAIM(check_tree(nearer, t, tree).has_value());
  CLAIM(!check_tree(drawn.query, t, tree));
}

/// Proofs that patches do not touch prove nothing of distances.
void check_proofs_of_touching(Draw& d) {
  constexpr double kLittle = 0x1p-30;
  FirstContact drawn = draw_first_contact(d);
  show(d, "query", drawn.query);
  const MovingPlane plane = supposed(find_plane(drawn.query, drawn.witness));
  drawn.query.separation = kLittle;
  CLAIM(!check_plane(drawn.query, plane));

  Query linear = supposed(draw_linear(d));
  const Decision decision = decide_linear(linear, {});
  suppose(decision.truth.clearance.has_value());
  show(d, "linear", linear);
  linear.separation = kLittle;
  CLAIM(!check_clearance(linear, *decision.truth.clearance, ""));
}

/// A hit is at the distance, as far as doubles tell, or with pops as far as cells do.
void claim_at_distance(const Query& query, double size, Draw& d) {
  const Answer answer = asked(d, "tdibm-c", query, {});
  constexpr std::uint64_t kFewPops = 300;
  if (answer.verdict == Verdict::kMiss) {
    CLAIM(decide_briefly(query, kFewPops).truth.collides != true);
  }
  if (answer.verdict != Verdict::kHit) return;
  // Bounds, and the last step of 2^-44 of the way, are well below 2^-24 of the size. Cells of the
  // precision 1e-4 are below 2^-10 of it.
  Query nearly = query;
  nearly.separation += size * (answer.pops == 0 ? 0x1p-24 : 0x1p-10);
  CLAIM(decide_briefly(nearly, kFewPops).truth.collides != false);
}

/// A hit on a linear query is a contact, and a miss is none, in both orders of the patches.
void check_linear_apart(Draw& d) {
  Query query = supposed(draw_linear(d));
  const double size = largest_coordinate_at_ends(query);
  const int exponent = -d.integer(0, 12);
  query.separation = size * std::ldexp(d.pick(std::array{1.0, 1.25}), exponent);
  suppose(is_valid(query) && query.separation > 0x1p-900 && size < 0x1p900);
  claim_at_distance(query, size, d);
  std::swap(query.patches[0], query.patches[1]);
  claim_at_distance(query, size, d);
}

}  // namespace

std::vector<Property> distances_claims() {
  constexpr auto kMeaning = "src/case/query.hpp";
  constexpr auto kCertified = "src/ccd/certified/DERIVATION.md, 8";
  constexpr auto kRational = "src/ccd/rational/exact_scene.hpp";
  std::vector<Property> claims = {
      {"separation.not_early",
       "A hit at a distance is no earlier than the width of its boxes explains", kMeaning,
       check_not_early_apart},
      {"separation.refuses_nearer",
       "A tree that proves a share of a distance, also of round patches, is no proof of all of it",
       "src/certify/checker/check_tree.hpp", check_trees},
      {"separation.refuses_proofs_of_touching",
       "Planes and linear decisions, which prove that nothing touches, prove no distance",
       "src/certify/checker/check_plane.hpp", check_proofs_of_touching},
      {"tdibm-c.linear_apart", "A hit on a linear query is at that distance, and a miss is none",
       kCertified, check_linear_apart},
  };
  add_claims_of(claims, {"separation",
                         "apart",
                         "at a distance",
                         {kCertified, kRational},
                         &Features::separation,
                         {Family::kApart, Family::kSeparated},
                         draw_case_apart});
  return claims;
}

}  // namespace ccdfuzz
