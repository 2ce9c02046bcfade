#include <cmath>

#include "case/scale.hpp"
#include "certify/checker/check_plane.hpp"
#include "certify/checker/check_truth.hpp"
#include "certify/checker/check_witness.hpp"
#include "certify/oracle/build_tree.hpp"
#include "certify/oracle/find_plane.hpp"
#include "certify/oracle/oracle.hpp"
#include "generators/draw_patch.hpp"
#include "method/method.hpp"
#include "properties/answers.hpp"
#include "properties/draw_linear.hpp"
#include "properties/draw_trimmed.hpp"
#include "properties/draw_weighted.hpp"
#include "properties/linear_queries.hpp"
#include "properties/query_kind.hpp"
#include "properties/show.hpp"

namespace ccdfuzz {

namespace {

/// Equal weights are none, to each method.
void check_equal_weights(Draw& d) {
  const Case plain = supposed(draw_contact(d, {-2, 2, 3}));
  Query weighted = plain.query;
  const double weight = std::abs(d.finite_double());
  suppose(weight > 0);
  for (MovingPatch<double>& patch : weighted.patches) {
    patch.weights.assign(patch.positions.size(), weight);
  }
  show(d, "query", weighted);
  claim_answered_alike(every_method_but(), weighted, plain.query, kQuickSearch);
}

/// Weights are valid iff they are finite, > 0 and of exponents that are near enough.
void check_valid(Draw& d) {
  Query query = draw_any_query(d);
  MovingPatch<double>& patch = query.patches[d.choose(1)];
  std::vector<double>& weights = patch.weights;
  for (std::size_t i = 0; i < query.patches[0].positions.size(); ++i) {
    weights.push_back(d.coin() ? d.finite_double() : std::ldexp(1.5, d.integer(-31, 31)));
  }
  int lowest = 1 << 20, highest = -lowest;
  bool is_good = weights.size() == patch.positions.size();
  for (const double w : weights) {
    is_good = is_good && w > 0;
    if (!(w > 0)) continue;
    lowest = std::min(lowest, std::ilogb(w));
    highest = std::max(highest, std::ilogb(w));
  }
  is_good = is_good && highest - lowest <= kWeightBits;
  show(d, "query", query);
  CLAIM(is_valid(query) == is_good);
}

/// All weights of a patch times a power of two are the same to each method. The plain form of a
/// method of the paper answers as it does.
void check_scaled_weights(Draw& d) {
  const Query query = show(d, "query", draw_weighted_contact(d).query);
  Query scaled = query;
  const int exponent = d.integer(-1000, 960);
  for (double& w : scaled.patches[d.choose(1)].weights) w = std::ldexp(w, exponent);
  claim_answered_alike(every_method_but({"oracle"}), scaled, query, kQuickSearch);
  const std::string name = d.pick(std::array{"tdibm", "tdibm-e"});
  claim_same(answer_of(name, query, kQuickSearch),
             answer_of(name + kUnoptimised, query, kQuickSearch));
}

/// Points, edges and triangles are the same sets with weights as without. Parameters are those with
/// weights: they name about the same place.
void check_linear(Draw& d) {
  const Query plain = supposed(draw_linear(d));
  suppose(most_places(plain) <= 254);  // what wider ones leave open, boxes decide
  Query weighted = plain;
  for (MovingPatch<double>& patch : weighted.patches) {
    patch.weights = draw_patch_weights(d, patch.positions.size());
  }
  for (const std::string method : {"tdibm-c", "oracle"}) {
    const Answer with = asked(d, method, weighted, kQuickSearch);
    const Answer without = asked(d, method, plain, kQuickSearch);
    CLAIM(with.verdict == without.verdict && with.toi == without.toi);
    for (std::size_t s = 0; s < 2 && with.verdict == Verdict::kHit; ++s) {
      const MovingPatch<double>&a = weighted.patches[s], &b = plain.patches[s];
      CLAIM(a.shape.contains(with.uv[s]));
      const Vec3<Rational> off =
          point_of(a, exact_place(with.uv[s]), 0) - point_of(b, exact_place(without.uv[s]), 0);
      const Rational most = exact(largest_coordinate(b.positions)) * power_of_two(-10);
      for (int k = 0; k < 3; ++k) CLAIM(abs(off[k]) <= most);
    }
  }
  const Decision decision = decide(weighted);
  CLAIM(decision.truth.collides == decide(plain).truth.collides);
  CLAIM(!decision.truth.witness || check_contact(weighted, *decision.truth.witness));
}

/// A tree that separates up to a time is refused after the first contact. A plane through the
/// contact separates before it iff it does so without weights, as they keep tangents and heights'
/// signs; and no later.
void check_clearances(Draw& d) {
  Query plain;
  const FirstContact drawn = draw_weighted_first_contact(d, &plain);
  show(d, "query", drawn.query);
  const Witness& witness = *drawn.truth.witness;
  const auto plane = find_plane(drawn.query, witness);
  CLAIM(plane.has_value() == find_plane(plain, witness).has_value());
  if (plane) {
    MovingPlane later = *plane;
    later.until += power_of_two(-30);
    CLAIM(!check_plane(drawn.query, later));
  }
  constexpr std::uint64_t kFewNodes = 1000;
  const Rational before = witness.t * 3 / 4;
  const auto tree = supposed(build_miss_tree(drawn.query, before, kFewNodes));
  CLAIM(check_clearance(drawn.query, tree).has_value());
  CLAIM(!check_clearance(drawn.query, MissTree{witness.t, tree.tree}));
}

}  // namespace

std::vector<Property> weights_claims() {
  constexpr auto kCertified = "src/ccd/certified/DERIVATION.md, 9";
  constexpr auto kRational = "src/ccd/rational/gap.cpp";
  constexpr auto kPatch = "src/bezier/patch.hpp";
  constexpr auto kChecker = "src/case/certificate.hpp";
  std::vector<Property> claims = {
      {"weights.valid", "Weights are valid iff they are > 0 and of exponents at most 60 apart",
       "src/case/query.hpp", check_valid},
      {"weights.equal_are_none", "Equal weights change no bit of an answer", kPatch,
       check_equal_weights},
      {"weights.scale_alike", "Weights times a power of two change no bit of an answer", kPatch,
       check_scaled_weights},
      {"weights.linear",
       "Weights change no verdict, time or place that tdibm-c and the oracle say of linear patches",
       "src/ccd/certified/DERIVATION.md, 6", check_linear},
      {"weights.clearances", "Planes and trees of rational patches prove what is before a contact",
       kChecker, check_clearances},
  };
  add_claims_of(claims, {"weights",
                         "weighted",
                         "of rational patches",
                         {{"tdibm-c", kCertified}, {"tdibm-rational", kRational}},
                         &Features::weights,
                         {Family::kWeighted, Family::kRound},
                         [](Draw& d) { return case_of(draw_weighted_contact(d)); }});
  return claims;
}

}  // namespace ccdfuzz
