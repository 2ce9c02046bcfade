#include "generators/round.hpp"

#include <cmath>

#include "certify/oracle/find_contact.hpp"
#include "certify/oracle/oracle.hpp"
#include "method/method.hpp"
#include "properties/answers.hpp"
#include "properties/show.hpp"

namespace ccdfuzz {

namespace {

Case draw_round(Draw& d, bool apart) {
  const ContactClass contact = d.coin() ? ContactClass::kVF : ContactClass::kFF;
  return draw_round_case(contact, apart, d);
}

/// A box about the place where a point comes to the surface is found.
void check_place(const Case& drawn) {
  Query longer = drawn.query;
  longer.t_max = 4;
  const Witness& witness = *drawn.truth.witness;
  const Uv<double> near = {witness.uv[0][0].get_d(), witness.uv[0][1].get_d()};
  const auto box = find_contact_box(longer, {{near, {0, 0}}, witness.t.get_d(), 0x1p-20});
  CLAIM(box.has_value());
  for (std::size_t k = 0; k < 2; ++k) {
    CLAIM(box->varied[k] == static_cast<int>(k));
    CLAIM(abs(exact(box->centre[k]) - witness.uv[0][k]) <= exact(box->radius[k]));
  }
}

void check_first_contact(Draw& d) {
  Case drawn = draw_round(d, d.choose(3) == 3);
  Query& query = drawn.query;
  const bool apart = query.separation > 0;
  if (query.patches[1].shape.kind == ShapeKind::kPoint && !apart) check_place(drawn);
  const Rational& t = drawn.truth.witness->t;
  const bool before = d.coin();
  if (before) query.t_max = t.get_d() * (1 - std::ldexp(1.0, -d.integer(2, 6)));
  show(d, "query", query);
  SearchOptions fine{.precision = 0x1p-14, .max_pops = 20'000};
  for (const std::string method : {"tdibm-c", "tdibm-rational"}) {
    if (method == "tdibm-rational") fine.max_pops = 500;           // each takes it about 0.1 ms
    if (method == "tdibm-rational" && d.choose(7) != 0) continue;  // slow
    const Answer answer = asked(d, method, query, fine);
    if (answer.verdict == Verdict::kUndecided) continue;
    // At a distance boxes are told apart no finer than their size: a hit may be early by that.
    CLAIM(!before || apart || answer.verdict == Verdict::kMiss);
    if (before) continue;
    CLAIM(answer.verdict == Verdict::kHit);
    CLAIM(exact(*answer.toi) <= t);
    CLAIM(apart || exact(*answer.toi) >= t - power_of_two(-10));
  }
  if (d.choose(3) != 0) return;
  const Decision decision = decide(query, {.max_pops = 300, .max_tree_nodes = 500});
  CLAIM(decision.truth.collides.value_or(!before) == !before);
  const auto by = decision.truth.contact_by();
  CLAIM(!by || *by >= t);
  const auto& clear = decision.truth.clear_until;
  CLAIM(before || !clear || *clear <= t);
}

}  // namespace

std::vector<Property> round_claims() {
  return {
      {"weights.round", "Spheres, cylinders, cones and tori first touch when a closed formula says",
       "generators/round.hpp", check_first_contact},
  };
}

}  // namespace ccdfuzz
