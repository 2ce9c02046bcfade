#include "generators/round.hpp"

#include <cmath>

#include "certify/oracle/find_contact.hpp"
#include "certify/oracle/oracle.hpp"
#include "method/method.hpp"
#include "properties/answers.hpp"
#include "properties/closed_formula.hpp"
#include "properties/show.hpp"

namespace ccdfuzz {

namespace {

/// When patches first touch.
struct FirstTouch {
  /// It is not before the first time, and not after the second. nullopt: not in [0, t_max].
  std::optional<std::array<Rational, 2>> times;
  /// Whether a hit at this time is no earlier than its boxes explain.
  std::function<bool(const Rational& toi)> may_hit;
};

constexpr SearchOptions kFine = {0x1p-14, 20'000, SearchOptions().max_bytes};

/// Requires a method that takes the query.
void claim_answer(Draw& d, const std::string& method, const Query& query, const FirstTouch& touch,
                  const SearchOptions& options = kFine) {
  const Answer answer = asked(d, method, query, options);
  if (answer.verdict == Verdict::kUndecided) return;
  const bool is_hit = answer.verdict == Verdict::kHit;
  CLAIM(is_hit || !touch.times);
  CLAIM(!is_hit || !touch.times || exact(*answer.toi) <= touch.times->back());
  CLAIM(!is_hit || touch.may_hit(exact(*answer.toi)));
}

/// The methods that miss nothing, of which the slow ones are not always asked.
void claim_answers(Draw& d, const Query& query, const FirstTouch& touch) {
  show(d, "query", query);
  claim_answer(d, "tdibm-c", query, touch);
  SearchOptions few = kFine;
  few.max_pops = 500;  // each takes about 0.1 ms
  if (d.choose(3) == 0) claim_answer(d, "tdibm-rational", query, touch, few);
  if (d.choose(3) != 0) return;
  const Decision decision = decide(query, {.max_pops = 300, .max_tree_nodes = 500});
  const bool touches = touch.times.has_value();
  CLAIM(decision.truth.collides.value_or(touches) == touches);
  if (!touches) return;
  const auto by = decision.truth.contact_by();
  CLAIM(!by || *by >= touch.times->front());
  const auto& clear = decision.truth.clear_until;
  CLAIM(!clear || *clear <= touch.times->back());
}

/// A formula with a query that ends before the first touch or after it, by 2^-40 of its time or
/// more.
ClosedFormula draw_formula(Draw& d, bool separation, bool of_point = false) {
  ClosedFormula drawn = draw_closed_formula(separation, of_point, d);
  if (!drawn.times) return drawn;
  const bool before = d.coin();
  const double share = std::ldexp(1.0, -d.integer(1, 40));
  const double time = before ? round_down(drawn.times->front()) : round_up(drawn.times->back());
  drawn.query.t_max = time * (before ? 1 - share : 1 + share);
  if (before) drawn.times.reset();
  return drawn;
}

void check_formula(Draw& d) {
  const bool separation = d.choose(3) == 3;
  const ClosedFormula drawn = draw_formula(d, separation);
  const auto may_hit = [&](const Rational& toi) { return drawn.is_within(drawn.slack, toi); };
  claim_answers(d, drawn.query, {drawn.times, may_hit});
}

/// A method that has no proof, coarsely: boxes are 64 times as large.
std::function<void(Draw&)> keeps_formulas(const std::string& method) {
  return [=](Draw& d) {
    const ClosedFormula drawn = draw_formula(d, false, d.coin());
    const auto may_hit = [&](const Rational& toi) {
      return drawn.is_within(64 * drawn.slack, toi);
    };
    claim_answer(d, method, drawn.query, {drawn.times, may_hit},
                 {0x1p-8, 500, SearchOptions().max_bytes});
  };
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

void check_planted(Draw& d) {
  const bool apart = d.choose(3) == 3;
  const ContactClass contact = d.coin() ? ContactClass::kVF : ContactClass::kFF;
  Case drawn = draw_round_case(contact, apart, d);
  if (contact == ContactClass::kVF && !apart) check_place(drawn);
  const Rational& t = drawn.truth.witness->t;
  FirstTouch touch = {{{t, t}}, [&](const Rational& toi) {
                        // At a distance boxes are told apart no finer than their size.
                        return apart || toi >= t - power_of_two(-10);
                      }};
  if (d.coin()) {
    drawn.query.t_max = t.get_d() * (1 - std::ldexp(1.0, -d.integer(2, 6)));
    touch.times.reset();
  }
  claim_answers(d, drawn.query, touch);
}

}  // namespace

std::vector<Property> round_claims() {
  constexpr auto kFormula = "properties/closed_formula.hpp";
  std::vector<Property> claims = {
      {"weights.round",
       "Spheres, cylinders, cones and tori first touch when and where a contact was planted, for "
       "tdibm-c, tdibm-rational and the oracle",
       "generators/round.hpp", check_planted},
      {"weights.closed_formulas",
       "Spheres, cylinders, tori, planes and points first touch when a closed formula of their "
       "centres, axes, radii and velocities says, for tdibm-c, tdibm-rational and the oracle",
       kFormula, check_formula},
  };
  for (const auto& [method, expected] : {std::pair<std::string, Expectation>{"tdibm", kFails},
                                         {"tdibm-h:1e-12", kFails},
                                         {"tdibm-e", kHolds},
                                         {"trad", kFails}}) {
    claims.push_back({"weights.closed_formulas_" + method.substr(0, method.find(':')),
                      fmt::format("No first touch that a closed formula gives is missed or late, "
                                  "nor early by more than boxes explain, for {}",
                                  method),
                      kFormula, keeps_formulas(method), expected});
  }
  return claims;
}

}  // namespace ccdfuzz
