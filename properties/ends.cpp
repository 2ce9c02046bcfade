#include "generators/ends.hpp"

#include <cmath>

#include "certify/checker/check_linear.hpp"
#include "fuzz/mutator/moves.hpp"
#include "method/method.hpp"
#include "properties/answers.hpp"
#include "properties/query_kind.hpp"
#include "properties/show.hpp"

namespace ccdfuzz {

namespace {

/// A contact of a range with ends in place of velocities, of one patch or both, where at least one
/// difference to a position is no double.
Case draw_contact_with_ends(Draw& d, const ContactRange& range) {
  Contact q = supposed(contact_of(supposed(draw_contact(d, range))));
  suppose(give_ends(q, d));
  constexpr int kMostTries = 16;
  for (int n = 0; n < kMostTries && with_velocities(q.query); ++n) {
    if (n % 2 == 0) {
      if (const auto moved = parted(case_of(q), d)) q.query = moved->query;
    } else if (Contact next = q; shift_in_null_space(next, d)) {
      q = std::move(next);
    }
  }
  suppose(!with_velocities(q.query));
  return case_of(q);
}

/// Velocities are the differences of ends and positions, exactly.
void claim_same_way(const Query& of_ends, const Query& of_velocities) {
  for (std::size_t s = 0; s < 2; ++s) {
    const MovingPatch<double>&a = of_ends.patches[s], &b = of_velocities.patches[s];
    for (std::size_t i = 0; a.has_ends() && i < a.positions.size(); ++i) {
      CLAIM(exact(a.ends[i]) - exact(a.positions[i]) == exact(b.velocities[i]));
    }
  }
}

/// Where all differences are doubles, ends are the same motion as velocities. No query is past
/// them.
void check_same_motion(Draw& d) {
  Contact q = supposed(contact_of(supposed(draw_contact(d, kOrdinaryRange))));
  suppose(give_ends(q, d));
  const Query plain = supposed(with_velocities(q.query));
  Query past = q.query;
  past.t_max = 1 + std::ldexp(1, -d.integer(0, 52));
  show(d, "query", q.query);
  CLAIM(!is_valid(past));
  claim_same_way(q.query, plain);
  if (const auto moved = parted(case_of(q), d)) {
    const auto velocities = with_velocities(moved->query);
    if (velocities) claim_same_way(moved->query, *velocities);
  }
  for (const std::string method : {"tdibm-rational", "tdibm-c"}) {
    const Answer of_ends = asked(d, method, q.query, kQuickSearch);
    const Answer of_velocities = asked(d, method, plain, kQuickSearch);
    // Other bounds may part other boxes: verdicts differ at most where a budget ends a search.
    const auto decided = [](const Answer& a) { return a.verdict != Verdict::kUndecided; };
    CLAIM(of_ends.verdict == of_velocities.verdict || !decided(of_ends) || !decided(of_velocities));
  }
  claim_answered_alike({"tdibm", "tdibm-e", "trad"}, q.query, plain, kQuickSearch);
}

/// No proof of linear patches reaches a contact, however little it is off their rounded motion.
void check_late_linear_proof(Draw& d) {
  constexpr std::array kLinear = {Shape::point(), Shape::curve(1), Shape::triangle(1)};
  const Shape first = d.pick(kLinear), second = d.pick(kLinear);
  suppose(is_linear_pair(first, second));
  const Case drawn = show(d, "contact", draw_contact_with_ends(d, {.shapes = {{first, second}}}));
  CLAIM(!check_linear_clearance(drawn.query, {drawn.truth.witness->t, true}));
}

}  // namespace

std::vector<Property> ends_claims() {
  constexpr auto kCertified = "src/ccd/certified/DERIVATION.md, 1";
  constexpr auto kRational = "src/ccd/rational/gap.cpp";
  std::vector<Property> claims = {
      {"ends.same_motion",
       "Ends whose ways are doubles are answered as these velocities are; nothing is asked past "
       "them",
       "src/method/taken_query.hpp", check_same_motion},
      {"ends.no_late_linear_proof",
       "No proof that linear patches with ends do not touch reaches their contact",
       "src/certify/checker/check_linear.hpp", check_late_linear_proof},
  };
  add_claims_of(claims, {"ends",
                         "ends",
                         "of patches with ends",
                         {{"tdibm-c", kCertified}, {"tdibm-rational", kRational}},
                         &Features::ends,
                         {Family::kEnds, Family::kEnds},
                         [](Draw& d) { return draw_contact_with_ends(d, kElsewhere); }});
  return claims;
}

}  // namespace ccdfuzz
