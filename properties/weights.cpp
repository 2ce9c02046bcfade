#include <cmath>

#include "bezier/bernstein.hpp"
#include "bezier/exact_patch.hpp"
#include "bezier/restrict.hpp"
#include "ccd/certified/cell_tree.hpp"
#include "ccd/certified/kernels.hpp"
#include "ccd/certified/normalise.hpp"
#include "ccd/certified/window_trim.hpp"
#include "certify/checker/check_plane.hpp"
#include "certify/checker/check_tree.hpp"
#include "certify/checker/check_truth.hpp"
#include "certify/checker/check_witness.hpp"
#include "certify/oracle/build_tree.hpp"
#include "certify/oracle/find_plane.hpp"
#include "certify/oracle/oracle.hpp"
#include "files/case_json.hpp"
#include "fuzz/mutator/case_bytes.hpp"
#include "generators/draw_patch.hpp"
#include "method/method.hpp"
#include "properties/answers.hpp"
#include "properties/draw_linear.hpp"
#include "properties/draw_weighted.hpp"
#include "properties/linear_queries.hpp"
#include "properties/query_kind.hpp"
#include "properties/show.hpp"

namespace ccdfuzz {

namespace {

Case draw_weighted_case(Draw& d) {
  return case_of(draw_weighted_contact(d));
}

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
  claim_answered_alike(
      std::array{"tdibm-c", "tdibm-rational", "oracle", "tdibm", "tdibm-e", "trad"}, weighted,
      plain.query, kQuickSearch);
}

/// Weights are valid iff they are finite, > 0 and of exponents that are near enough.
void check_valid(Draw& d) {
  Query query = draw_any_query(d);
  MovingPatch<double>& patch = query.patches[d.choose(1)];
  std::vector<double>& weights = patch.weights;
  for (std::size_t i = 0; i < query.patches[0].positions.size(); ++i) {
    weights.push_back(d.coin() ? d.finite_double()
                               : std::ldexp(1.5, static_cast<int>(d.integer(-31, 31))));
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
  CLAIM(validate(query, "").has_value() == is_good);
}

/// All weights of a patch times a power of two are the same to each method. The plain form of a
/// method of the paper answers as it does.
void check_scaled_weights(Draw& d) {
  const Query query = draw_weighted_contact(d).query;
  Query scaled = query;
  const auto exponent = static_cast<int>(d.integer(-1000, 960));
  for (double& w : scaled.patches[d.choose(1)].weights) w = std::ldexp(w, exponent);
  show(d, "query", query);
  claim_answered_alike(std::array{"tdibm-c", "tdibm-rational", "tdibm", "trad"}, scaled, query,
                       kQuickSearch);
  claim_same(make_method("tdibm").value()->answer(query, kQuickSearch),
             make_method("tdibm@unoptimised").value()->answer(query, kQuickSearch));
}

/// Points, edges and triangles are the same sets with weights as without.
void check_linear(Draw& d) {
  const Query plain = supposed(draw_linear(d));
  suppose(most_places(plain) <= 254);  // what wider ones leave open, boxes decide
  Query weighted = plain;
  for (MovingPatch<double>& patch : weighted.patches) {
    patch.weights = draw_patch_weights(d, patch.positions.size());
  }
  const Answer with = asked(d, "tdibm-c", weighted, kQuickSearch);
  const Answer without = asked(d, "tdibm-c", plain, kQuickSearch);
  CLAIM(with.verdict == without.verdict && with.toi == without.toi);
  for (std::size_t s = 0; s < 2; ++s) CLAIM(weighted.patches[s].shape.contains(with.uv[s]));
  const Decision decision = decide(weighted);
  CLAIM(decision.truth.collides == decide(plain).truth.collides);
  if (!decision.truth.witness || with.verdict != Verdict::kHit) return;
  // Both name about the same point, where there is but one.
  const Witness& witness = *decision.truth.witness;
  CLAIM(check_contact(weighted, witness).has_value());
}

/// A point of a patch is where tdibm-c says: that of its own uv, not of a patch without weights.
void check_linear_place(Draw& d) {
  Query query;
  auto& [edge, other] = query.patches;
  edge = {Shape::curve(1), {{0, 0, 0}, {1, 0, 0}}, {{0, 0, 0}, {0, 0, 0}}};
  if (d.coin()) {
    edge = {Shape::triangle(1), {{0, 0, 0}, {0, 1, 0}, {1, 0, 0}}, {}};
    edge.velocities.assign(3, Vec3<double>(0, 0, 0));
  }
  edge.weights = draw_patch_weights(d, edge.positions.size());
  const auto sixteenths = [&] { return static_cast<double>(d.integer(0, 8)) / 16; };
  const double x = sixteenths();
  const double y = edge.positions.size() == 3 ? sixteenths() : 0;
  if (edge.positions.size() == 2) {
    other = {Shape::curve(1), {{x, -1, 1}, {x, 1, 1}}, {{0, 0, -1}, {0, 0, -1}}};
  } else {
    other = {Shape::point(), {{x, y, 1}}, {{0, 0, -1}}};
  }
  for (const std::string method : {"tdibm-c", "oracle"}) {
    const Answer answer = asked(d, method, query, kQuickSearch);
    CLAIM(answer.verdict == Verdict::kHit);
    const auto& [u, v] = answer.uv[0];
    const Vec3<Rational> at = point_of(edge, {exact(u), exact(v)}, 0);
    const double off = std::hypot(at[0].get_d() - x, at[1].get_d() - y);
    show(d, "off", off);
    CLAIM(off < 0x1p-10);
  }
}

void check_not_early(Draw& d) {
  const FirstContact drawn = draw_weighted_first_contact(d);
  claim_not_early(d.pick(std::array{"tdibm-c", "tdibm-rational"}), drawn, d);
}

/// A tree that separates up to a time is refused after the first contact. A plane through the
/// contact separates before it iff it does so without weights, as they keep tangents and heights'
/// signs; and no later.
void check_clearances(Draw& d) {
  Query plain;
  const FirstContact drawn = draw_weighted_first_contact(d, &plain);
  show(d, "query", drawn.query);
  const Rational& t = drawn.witness.t;
  const auto plane = find_plane(drawn.query, drawn.witness);
  CLAIM(plane.has_value() == find_plane(plain, drawn.witness).has_value());
  if (plane) {
    MovingPlane later = *plane;
    later.until += power_of_two(-30);
    CLAIM(!check_plane(drawn.query, later));
  }
  constexpr std::uint64_t kFewNodes = 1000;
  const Rational before = t * 3 / 4;
  const auto tree = supposed(build_miss_tree(drawn.query, before, kFewNodes));
  CLAIM(check_tree(drawn.query, before, tree).has_value());
  CLAIM(!check_tree(drawn.query, t, tree));
}

/// Controls of a net, and weights whose exponents differ by up to kWeightBits.
struct WeightedNet {
  Shape shape;
  std::vector<std::array<double, 6>> controls;
  std::vector<double> weights;
};

WeightedNet draw_net(Draw& d) {
  WeightedNet net;
  net.shape = draw_shape(d, 3);
  suppose(net.shape.kind != ShapeKind::kPoint);
  const auto count = static_cast<std::size_t>(net.shape.control_count());
  const bool is_subnormal = d.choose(7) == 7;
  for (std::size_t i = 0; i < count; ++i) {
    auto& control = net.controls.emplace_back();
    for (double& x : control) {
      x = *(is_subnormal ? d.dyadic(8, -1074) : d.dyadic(53, -53)).to_double_exactly();
    }
    const int exponent = d.coin() ? 0 : -static_cast<int>(d.integer(0, kWeightBits));
    net.weights.push_back(
        std::ldexp(1 + std::abs(d.dyadic(30, -31).to_double_exactly().value()), exponent));
  }
  net.weights[d.below(count)] = 1;
  return net;
}

/// Control points of cells at a time, and their heights on an axis, are off by the roundings that
/// tdibm-c counts at most.
void check_cells(Draw& d) {
  const WeightedNet net = draw_net(d);
  certified::CellTree tree;
  tree.reset(net.shape, net.controls, net.weights);
  certified::CellTree::Node node = 0;
  for (auto levels = d.choose(6); levels > 0; --levels) {
    const auto which = d.choose(static_cast<std::uint64_t>(net.shape.child_count() - 1));
    node = tree.children(node) + static_cast<certified::CellTree::Node>(which);
  }
  const double t = *abs(d.dyadic(53, -53)).to_double_exactly();
  MovingPatch<Rational> whole{net.shape, {}, {}};
  Rational largest_p = 0, largest_v = 0;
  for (std::size_t i = 0; i < net.controls.size(); ++i) {
    const auto& c = net.controls[i];
    whole.positions.push_back({exact(c[0]), exact(c[1]), exact(c[2])});
    whole.velocities.push_back({exact(c[3]), exact(c[4]), exact(c[5])});
    whole.weights.push_back(exact(net.weights[i]));
    for (std::size_t k = 0; k < 3; ++k) {
      largest_p = std::max(largest_p, Rational(abs(exact(c[k]))));
      largest_v = std::max(largest_v, Rational(abs(exact(c[k + 3]))));
    }
  }
  const Cell cell = tree.cell(node);
  const MovingPatch<Rational> part =
      restrict_to<Rational>(whole, exact_corners<Rational>(cell.corners(net.shape)));
  const Points<Rational> at = part.at(exact(t));
  std::vector<double> snapshot(certified::kPerPoint * net.controls.size());
  certified::take_snapshot(tree.net(node), tree.count(), 0, t, snapshot.data());
  const int roundings = tree.roundings(tree.depth(node));
  show(d, "shape", net.shape);
  show(d, "cell", cell);
  show(d, "t", t);
  show(d, "controls", net.controls);
  show(d, "weights", net.weights);
  const int averages = (net.shape.n + net.shape.m) * tree.depth(node);
  CLAIM(roundings == 2 * averages + 2);
  // One more of the product with t, and one of the sum.
  const Rational relative = exact(std::ldexp(roundings + 2, -53)) * (1 + power_of_two(-20));
  const Rational allowed = relative * (largest_p + largest_v) + power_of_two(-1001);
  certified::Axis axis;
  for (double& x : axis) x = *d.dyadic(53, -53).to_double_exactly();
  const certified::NetPair pair = {{tree.net(node), tree.net(node)}, {tree.count(), tree.count()}};
  const certified::HeightLines lines(pair, axis);
  Rational highest, lowest;
  for (std::size_t i = 0; i < at.size(); ++i) {
    Rational height = 0;
    for (int k = 0; k < 3; ++k) {
      const auto place = certified::kPerPoint * i + 4 + static_cast<std::size_t>(k);
      CLAIM(abs(exact(snapshot[place]) - at[i][k]) <= allowed);
      height += exact(axis[static_cast<std::size_t>(k)]) * at[i][k];
    }
    highest = i == 0 ? height : std::max(highest, height);
    lowest = i == 0 ? height : std::min(lowest, height);
    CLAIM(snapshot[certified::kPerPoint * i + 7] == 0);
  }
  const Rational norm =
      exact(std::abs(axis[0])) + exact(std::abs(axis[1])) + exact(std::abs(axis[2]));
  const Rational of_heights = 2 *
                                  (exact(std::ldexp(roundings + 8, -53)) * (1 + power_of_two(-20)) *
                                       (largest_p + largest_v) +
                                   power_of_two(-1001)) *
                                  norm +
                              power_of_two(-1000);
  CLAIM(abs(exact(lines.gap(0, t).height) - (highest - lowest)) <= of_heights);
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
      {"weights.linear", "Weights change no verdict or time of linear patches",
       "src/ccd/certified/DERIVATION.md, 6", check_linear},
      {"weights.linear_place", "Parameters of contacts of linear patches are those with weights",
       "src/ccd/certified/DERIVATION.md, 6", check_linear_place},
      {"weights.clearances", "Planes and trees of rational patches prove what is before a contact",
       kChecker, check_clearances},
      {"weights.not_early", "A hit on rational patches is no earlier than its boxes explain",
       kCertified, check_not_early},
      {"tdibm-c.cells_weighted",
       "Control points of cells of rational patches are off by the roundings counted at most",
       kCertified, check_cells},
  };
  add_claims_of(claims, {"weights",
                         "weighted",
                         "of rational patches",
                         {kCertified, kRational},
                         &Features::weights,
                         draw_weighted_case});
  return claims;
}

}  // namespace ccdfuzz
