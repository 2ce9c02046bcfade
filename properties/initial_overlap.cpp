#include <cmath>

#include "certify/checker/check_case.hpp"
#include "certify/oracle/body_depth.hpp"
#include "method/ask.hpp"
#include "method/setting.hpp"
#include "properties/planted_bodies.hpp"
#include "properties/show.hpp"

namespace ccdfuzz {

namespace {

/// Bodies that touch or overlap at 0, and move on for however long.
Case draw_overlapping(Draw& d) {
  GeneratorOptions options;
  options.contact = d.pick(kContactClasses);
  options.family = Family::kBodies;
  options.initial_overlap = true;
  Case known = generate(options, d).value;
  known.query.t_max = std::ldexp(known.query.t_max, -d.integer(0, 20));
  show(d, "planted", known);
  CLAIM(known.truth.witness->t == 0);
  return known;
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
}

/// A way that is shorter than the tolerance excuses a late hit, but no miss.
void check_judged(Draw& d) {
  const Case known = draw_overlapping(d);
  const Query& query = known.query;
  const CheckedCase checked = value_or_throw(check_case(known));
  const double depth = supposed(depth_until(query, query.t_max));
  Answered answer;
  AnswerTerms& terms = answer.terms;
  terms.depth_tolerance = terms.space_tolerance = depth * d.pick(std::array{0.0, 0.5, 2.0});
  const auto outcome = [&](const Answer& said) {
    static_cast<Answer&>(answer) = said;
    return show(d, "outcome", outcome_of(checked, answer, true));
  };
  CLAIM(outcome(Answer::hit(0)) == Outcome::kCorrect);
  const bool is_deep = show(d, "depth", depth) > show(d, "tolerance", terms.depth_tolerance);
  CLAIM(outcome(Answer::miss()) == (is_deep ? Outcome::kMissed : Outcome::kCorrect));
  const double toi = show(d, "toi", std::ldexp(query.t_max, -d.integer(0, 30)));
  const double way = toi * (query.patches[0].velocities[0] - query.patches[1].velocities[0]).norm();
  const double before = supposed(depth_until(query, toi));
  suppose(std::abs(way - terms.depth_tolerance) >= 0x1p-40 * way);  // it is rounded
  const bool is_late = way > terms.depth_tolerance && before > terms.depth_tolerance;
  CLAIM(outcome(Answer::hit(toi)) == (is_late ? Outcome::kLate : Outcome::kCorrect));
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
  };
}

}  // namespace ccdfuzz
