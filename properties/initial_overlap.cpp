#include <cmath>
#include <numbers>

#include "certify/checker/check_case.hpp"
#include "certify/oracle/body_depth.hpp"
#include "certify/oracle/oracle.hpp"
#include "certify/oracle/outcome_of.hpp"
#include "generators/draw_patch.hpp"
#include "method/domain.hpp"
#include "method/setting.hpp"
#include "properties/planted_bodies.hpp"
#include "properties/show.hpp"

namespace ccdfuzz {

namespace {

/// Bodies that touch or overlap at 0, and move on for however long.
Case draw_overlapping(Draw& d) {
  const GeneratorOptions options = {
      .contact = d.pick(kContactClasses), .family = Family::kBodies, .initial_overlap = true};
  Case known = generate(options, d).value;
  known.query.t_max = std::ldexp(known.query.t_max, -d.integer(0, 20));
  show(d, "planted", known);
  CLAIM(known.truth.witness->t == 0);
  return known;
}

/// Turns or spins a body, from where it is at 0. Returns a bound of the speed that this adds.
double turn_from_start(Draw& d, MovingPatch<double>& body) {
  const auto eighths = [&] { return d.integer(-8, 8) / 8.0; };
  const auto vector = [&] { return Vec3<double>(eighths(), eighths(), eighths()); };
  BodyTurn& turn = body.turn.emplace();
  turn.centre = body.positions[0] + vector();
  const Vec3<double> axis = vector();
  double speed = 2 * axis.norm();  // of the angle 2 atan(|axis| t)
  if (d.coin()) {
    turn.spin = {axis[0], axis[1], axis[2]};
    speed = axis.norm();
  } else if (d.coin()) {
    turn.from = {2, 0, 0, 0};
    turn.to = {2, 2 * axis[0], 2 * axis[1], 2 * axis[2]};
  } else {
    turn.from = {1, 0};
    turn.to = {1, axis[2]};
    speed = std::abs(axis[2]);  // of the angle atan(z t)
  }
  double reach = 0;
  for (const Vec3<double>& p : body.positions) reach = std::max(reach, (p - turn.centre).norm());
  return speed * reach;
}

bool is_asked(const Domain& domain, const Case& value) {
  return domain.broken_by(value).empty();
}

void check_who_is_asked(Draw& d) {
  const Case known = draw_overlapping(d);
  suppose(setting_of(known) == Setting::kAtAnEnd);  // not degenerate
  Domain ordinary, promised;
  ordinary.ordinary = promised.ordinary = promised.initial_overlap = true;
  CLAIM(is_asked(promised, known) && !is_asked(ordinary, known));
  CLAIM(is_asked(*promised.with({}), known) && is_asked(*Domain().with(promised), known));
  CLAIM(is_asked(*promised.with(promised), known));
  CLAIM(!is_asked(*promised.with(ordinary), known) && !is_asked(*ordinary.with(promised), known));
  Case instant = known;
  instant.query.t_max = 0;
  CLAIM(!is_asked(promised, instant));
  // One that is apart at 0, however little.
  Case soon = draw_planted(d, CaseKind::kRP);
  soon.query.t_max = std::ldexp(soon.query.t_max, 20);
  suppose(setting_of(soon) == Setting::kAtAnEnd);
  CLAIM(!is_asked(promised, soon));
  // A mesh of one of their faces, which may be in contact at 0, too.
  Case mesh = known;
  MovingPatch<double>& body = mesh.query.patches[d.below(2)];
  suppose(body.positions.size() >= 3);
  body.shape = Shape::hull(3);
  body.positions.resize(3);
  body.radius = 0;
  body.faces = {{0, 1, 2}};
  mesh.truth = decide(mesh.query).truth;
  CLAIM(mesh.truth.contact_by() != Rational(0) || !is_asked(promised, mesh));
}

/// As far as both bounds of the step's angle tell apart.
void check_small_spins(Draw& d) {
  const GeneratorOptions options = {
      .contact = d.pick(kContactClasses), .family = Family::kSpinning, .most_spin = kSmallSpin};
  Query query = generate(options, d).value.query;
  show(d, "query", query);
  Domain small;
  small.most_spin = kSmallSpin;
  const auto is_taken = [&] { return small.broken_by(query).empty(); };
  CLAIM(is_taken());
  double most = 0;
  for (const MovingPatch<double>& body : query.patches) {
    if (!body.turn) continue;
    const auto& spin = body.turn->spin;
    most = std::max(most, query.t_max * std::hypot(spin[0], spin[1], spin[2]));
  }
  const double factor = std::numbers::pi / 4 / most;
  const auto faster = [&](double by) {
    for (MovingPatch<double>& body : query.patches) {
      if (!body.turn) continue;
      for (double& x : body.turn->spin) x *= by;
    }
  };
  faster(factor * (1 - 0x1p-40));
  CLAIM(is_taken() && small.with({})->broken_by(query).empty());
  faster(1 + 0x1p-38);
  CLAIM(!is_taken() && !Domain().with(small)->broken_by(query).empty());
  query.t_max /= 2;
  CLAIM(is_taken());
}

/// A way that is shorter than the tolerance excuses a late hit, but no miss. Nor does turning.
void check_judged(Draw& d) {
  Case known = draw_overlapping(d);
  Query& query = known.query;
  query.t_max = std::ldexp(query.t_max, -d.integer(0, 12));  // or nearly all ways are longer
  const double at_start = show(d, "depth at 0", supposed(depth_until(query, 0)));
  double speed = (query.patches[0].velocities[0] - query.patches[1].velocities[0]).norm();
  const std::uint64_t turning = d.below(16);  // the first, the second, both; mostly none, for time
  for (size_t s = 0; s < 2; ++s) {
    if (turning == s || turning == 2) speed += turn_from_start(d, query.patches[s]);
  }
  if (has_turns(query)) known.truth = decide(query).truth;
  show(d, "known", known);
  suppose(known.truth.contact_by() == Rational(0));  // of a spin, it may not be proven
  const CheckedCase checked = value_or_throw(check_case(known));
  const double depth = supposed(depth_until(query, query.t_max));
  CLAIM(depth >= at_start / 2);  // those that turn are rounded to about 2^-57 of a coordinate
  AnswerTerms terms;
  terms.depth_tolerance = terms.space_tolerance = depth * d.pick(std::array{0.0, 0.5, 0.9, 2.0});
  const auto outcome = [&](const Answer& said) {
    return show(d, "outcome", outcome_of(checked, said, terms, true));
  };
  CLAIM(outcome(Answer::hit(0)) == Outcome::kCorrect);
  const double tolerance = show(d, "tolerance", terms.depth_tolerance);
  // What turns may be deeper by a quarter than it is known to be, and is not known to be no deeper.
  const auto is_as_deep = [&](const Answer& said, double known_depth, Outcome wrong) {
    const Outcome got = outcome(said);
    if (known_depth > tolerance) return got == wrong;
    if (!has_turns(query)) return got == Outcome::kCorrect;
    return got == Outcome::kUnknown || (got == wrong && 1.25 * known_depth >= tolerance);
  };
  CLAIM(is_as_deep(Answer::miss(), show(d, "depth", depth), Outcome::kMissed));
  const double toi = show(d, "toi", std::ldexp(query.t_max, -d.integer(0, 30)));
  const double way = show(d, "way", toi * speed);
  const double before = supposed(depth_until(query, toi));
  suppose(std::abs(way - terms.depth_tolerance) >= 0x1p-40 * way);  // it is rounded
  CLAIM(way > tolerance ? is_as_deep(Answer::hit(toi), before, Outcome::kLate)
                        : outcome(Answer::hit(toi)) == Outcome::kCorrect);
}

}  // namespace

std::vector<Property> initial_overlap_claims() {
  return {
      {"initial_overlap.asked",
       "Bodies that touch or overlap at 0 are ordinary only for who promises to answer them",
       "src/method/domain.hpp", check_who_is_asked},
      {"initial_overlap.judged",
       "A miss of them is missed, and a hit after 0 is late, where they are deeper than the "
       "tolerance",
       "src/method/ask.hpp", check_judged},
      {"small_spins.asked",
       "Who promises spins by π/4 at most in the step is asked of these alone, and they are drawn",
       "src/method/domain.hpp", check_small_spins},
  };
}

}  // namespace ccdfuzz
