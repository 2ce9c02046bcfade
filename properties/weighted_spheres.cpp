#include <cmath>

#include "certify/checker/check_tree.hpp"
#include "certify/checker/check_witness.hpp"
#include "certify/oracle/build_tree.hpp"
#include "certify/oracle/find_contact.hpp"
#include "certify/oracle/oracle.hpp"
#include "method/method.hpp"
#include "properties/draw_weighted.hpp"
#include "properties/show.hpp"

namespace ccdfuzz {

namespace {

/// A point comes to a sphere where the closed formula says: that is a witness, and a box about it
/// is found.
void check_place(const RoundContact& drawn) {
  const bool is_witness = check_witness(drawn.query, {drawn.t, {drawn.uv, {0, 0}}}).has_value();
  CLAIM(is_witness);
  Query longer = drawn.query;
  longer.t_max = 4;
  const Uv<double> near = {drawn.uv[0].get_d(), drawn.uv[1].get_d()};
  const auto box = find_contact_box(longer, {{near, {0, 0}}, drawn.t.get_d(), 0x1p-20});
  CLAIM(box.has_value());
  const std::array<Rational, 2> place = {drawn.uv[0], drawn.uv[1]};
  for (std::size_t k = 0; k < 2; ++k) {
    CLAIM(box->varied[k] == static_cast<int>(k));
    CLAIM(abs(exact(box->centre[k]) - place[k]) <= exact(box->radius[k]));
  }
}

/// A tree that keeps spheres a distance apart is refused as a proof of one that they do not keep.
void check_separations(Draw& d) {
  const RoundContact drawn = draw_round_contact(d);
  suppose(drawn.query.separation > 0);
  show(d, "query", drawn.query);
  Query asked = drawn.query;
  asked.separation *= d.pick(std::array{0.0, 0.5, 1 - 0x1p-6});
  constexpr std::uint64_t kFewNodes = 3000;
  const auto tree = supposed(build_miss_tree(asked, drawn.t, kFewNodes));
  show(d, "separation", asked.separation);
  const bool is_accepted = check_tree(asked, drawn.t, tree).has_value();
  CLAIM(is_accepted);
  const bool is_false_accepted = check_tree(drawn.query, drawn.t, tree).has_value();
  CLAIM(!is_false_accepted);
}

/// Spheres of exact weights have the first contact of a closed formula.
void check_spheres(Draw& d) {
  RoundContact drawn = draw_round_contact(d);
  if (drawn.query.patches[1].shape.kind == ShapeKind::kPoint && drawn.query.separation == 0) {
    check_place(drawn);
  }
  const bool before = d.coin();
  if (before) drawn.query.t_max = 1 - std::ldexp(1.0, -static_cast<int>(d.integer(2, 6)));
  show(d, "query", drawn.query);
  const SearchOptions fine{.precision = 0x1p-14, .max_pops = 20'000};
  for (const std::string method : {"tdibm-c", "tdibm-rational"}) {
    if (method == "tdibm-rational" && d.choose(7) != 0) continue;  // slow
    const Answer answer = make_method(method).value()->answer(drawn.query, fine);
    show(d, method, std::string(name_of(answer.verdict)));
    show(d, "toi", answer.toi);
    if (answer.verdict == Verdict::kUndecided) continue;
    // At a distance boxes are told apart no finer than their size: a hit may be early by that.
    const bool apart = drawn.query.separation > 0;
    CLAIM(!before || apart || answer.verdict == Verdict::kMiss);
    if (before) continue;
    CLAIM(answer.verdict == Verdict::kHit);
    CLAIM(exact(*answer.toi) <= drawn.t);
    CLAIM(apart || exact(*answer.toi) >= drawn.t - power_of_two(-10));
  }
  if (d.choose(3) != 0) return;
  const Decision decision = decide(drawn.query, {.max_pops = 2000, .max_tree_nodes = 2000});
  CLAIM(decision.truth.collides.value_or(!before) == !before);
  const auto by = decision.truth.contact_by();
  CLAIM(!by || *by >= drawn.t);
  const auto& clear = decision.truth.clear_until;
  CLAIM(before || !clear || *clear <= drawn.t);
}

}  // namespace

std::vector<Property> weighted_spheres_claims() {
  return {
      {"weights.spheres", "Spheres touch when the closed formula says",
       "src/bezier/patch.hpp; |D + t·V|² = R²", check_spheres},
      {"weights.separations", "Trees that keep spheres apart prove no larger separation",
       "src/case/certificate.hpp", check_separations},
  };
}

}  // namespace ccdfuzz
