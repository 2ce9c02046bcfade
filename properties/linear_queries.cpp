#include "properties/linear_queries.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/double_parts.hpp"
#include "case/scale.hpp"
#include "ccd/certified/rough_contact.hpp"
#include "certify/linear/first_contact.hpp"
#include "certify/oracle/oracle.hpp"
#include "generators/draw_patch.hpp"
#include "method/method.hpp"
#include "properties/answers.hpp"
#include "properties/draw_linear.hpp"
#include "properties/show.hpp"

namespace ccdfuzz {

int most_places(const Query& query) {
  int most = 0;
  const DoubleParts step = parts_of(query.t_max);
  for (int k = 0; k < 3; ++k) {
    int least = std::numeric_limits<int>::max(), top = std::numeric_limits<int>::min();
    const auto note = [&](double x, int exponent, int above) {
      if (x == 0) return;
      least = std::min(least, parts_of(x).exponent + exponent);
      top = std::max(top, parts_of(x).top() + above);
    };
    for (const MovingPatch<double>& patch : query.patches) {
      for (const Vec3<double>& p : patch.positions) note(p[k], 0, 0);
      // A difference may have a place more than its numbers.
      const int top_of_way = step.top() + (patch.has_ends() ? 1 : 0);
      for (const Vec3<double>& v : patch.moves()) note(v[k], step.exponent, top_of_way);
      if (!patch.has_ends()) continue;
      for (const Vec3<double>& p : patch.positions) note(p[k], step.exponent, top_of_way);
    }
    if (least <= top) most = std::max(most, top - least);
  }
  return most;
}

namespace {

/// Less than 1 in magnitude, of 52 bits.
double full_number(Draw& choices) {
  return *choices.dyadic(52, -52).to_double_exactly();
}

Vec3<double> full_vector(Draw& choices) {
  return {full_number(choices), full_number(choices), full_number(choices)};
}

/// What is there at 0 is there at t.
void begin_before(Query& query, double t) {
  for (MovingPatch<double>& patch : query.patches) patch.positions = patch.at(-t);
}

/// A point and a triangle, or two edges, with numbers of full doubles, that graze each other. A
/// corner of one crosses the plane of the other on an edge, except for rounding, and its motion
/// across that edge is 0 there. So the last bits decide whether they touch. The corner stays on one
/// side of the edge for long, and where edges turn it may be on the other for a moment. The
/// crossing is in the time step, near its end or at it.
Query draw_grazing(Draw& choices) {
  Query query;
  auto& [a, b] = query.patches;
  const bool edges = choices.coin(), turns = choices.coin();
  a.shape = linear_shape(edges ? 2 : 3);
  b.shape = linear_shape(edges ? 2 : 1);
  // Positions at the time of the crossing first.
  for (MovingPatch<double>& patch : query.patches) {
    for (int i = 0; i < patch.shape.control_count(); ++i) {
      patch.positions.push_back(full_vector(choices));
      patch.velocities.push_back(turns || i == 0 ? full_vector(choices) : patch.velocities[0]);
    }
  }
  const Vec3<double> edge = a.positions[1] - a.positions[0];
  const Vec3<double> other =
      edges ? b.positions[1] - b.positions[0] : a.positions[2] - a.positions[0];
  int k = 0;  // the largest component of the normal
  edge.cross(other).cwiseAbs().maxCoeff(&k);
  // In that component the product of the edge and the motion is 0.
  Vec3<double> motion = full_number(choices) * edge;
  motion[k] += full_number(choices);
  const double share = choices.pick(std::array{0.0, 0.25, 0.5, 1.0});
  const auto on_edge = [share](const Points<double>& of) -> Vec3<double> {
    return (1 - share) * of[0] + share * of[1];
  };
  const Vec3<double> shift = on_edge(a.positions) - b.positions[0];
  const Vec3<double> change = on_edge(a.velocities) + motion - b.velocities[0];
  for (Vec3<double>& p : b.positions) p += shift;
  for (Vec3<double>& v : b.velocities) v += change;

  const double t = choices.pick(std::array{0.5, 0.75, 1.0, 1 - 0x1p-20});
  begin_before(query, t);
  query.t_max = 1;
  return query;
}

/// A degenerate query, made different by as little as 2^-60 of its size, or with a coordinate of
/// another scale than the others.
Result<Query> draw_nearly_degenerate(Draw& choices) {
  CCDFUZZ_TRY(Query drawn, draw_linear(choices));
  const double size = largest_coordinate(drawn);
  const auto k = static_cast<int>(choices.choose(2));
  if (choices.coin()) {
    MovingPatch<double>& patch = drawn.patches[choices.choose(1)];
    const int exponent = -choices.integer(1, 60);
    const double gap = (choices.coin() ? -size : size) * std::ldexp(1, exponent);
    const bool one_corner = choices.coin();
    for (Vec3<double>& p : patch.positions) {
      p[k] += gap;
      if (one_corner) break;
    }
  }
  if (choices.coin()) {
    const int exponent = choices.integer(-60, 60);
    for (MovingPatch<double>& patch : drawn.patches) {
      for (Points<double>* points : {&patch.positions, &patch.velocities}) {
        for (Vec3<double>& p : *points) p[k] = std::ldexp(p[k], exponent);
      }
    }
  }
  return drawn;
}

/// Whether an instant of exact arithmetic is at t or later.
bool is_at_least(linear::RealRoot instant, const Rational& t) {
  return instant.sign_of(linear::Polynomial({-t.get_num(), t.get_den()})) >= 0;
}

/// The oracle decides a linear query, and throws where the independent checker refuses what it
/// says: both exact codes agree, on contacts and on absence.
void check_decision(Draw& d) {
  const Query query = show(d, "query", supposed(draw_linear(d)));
  const Decision decision = decide(query);
  CLAIM(decision.truth.collides.has_value());
}

/// tdibm-c has the verdict of exact arithmetic on a linear query, and a toi that is neither late
/// nor early by more than the precision. Numbers of more than 254 binary places are outside of what
/// first_linear_contact promises. Patches have velocities, or ends, one or both, which a sum
/// rounds.
void check_answer(Draw& d) {
  Query query = supposed(d.choose(2) == 2 ? draw_grazing(d) : draw_nearly_degenerate(d));
  if (d.coin()) query = supposed(with_drawn_ends(query, d));
  suppose(most_places(query) <= 254);
  const SearchOptions options{.precision = d.pick(std::array{1e-4, 1e-1, 1e-12})};
  const auto contact = linear::first_contact(query);
  show(d, "precision", options.precision);
  const Answer answer = asked(d, "tdibm-c", query, options);
  CLAIM(answer.verdict == (contact ? Verdict::kHit : Verdict::kMiss));
  if (!contact) return;
  // Enclosures of times are halved until they are narrower than a thousandth of the precision.
  const Rational toi = exact(*answer.toi);
  const Rational allowed = exact(options.precision) * exact(query.t_max);
  auto time = *contact;
  while (time.hi() - time.lo() > allowed / 1024) time.refine();
  CLAIM(is_at_least(time, toi));
  CLAIM(time.lo() - toi <= allowed);
}

/// The window may end or begin at the contact, to the last double. Corners may pass each other, as
/// often inside as outside. The faster they are, the more often they are in one plane in it.
void check_doubles(Draw& d) {
  using certified::RoughContact;
  Query query = draw_touching_at_half(d, full_vector, false);
  const double apart = d.pick(std::array{0.0, 0.0, 0x1p-40, 0x1p-10});
  const Vec3<double> gap = apart * full_vector(d);
  for (Vec3<double>& p : query.patches[0].positions) p += gap;
  const double speed = apart == 0 ? d.pick(std::array{1.0, 8.0, 64.0}) : 1;
  begin_before(query, -0.5);
  for (MovingPatch<double>& patch : query.patches) {
    for (Vec3<double>& v : patch.velocities) v *= speed;
  }
  begin_before(query, 0.5);
  const double length = d.pick(std::array{0x1p-50, 0x1p-40, 0x1p-13, 0.25, 0.5});
  const double from = show(d, "from", d.pick(std::array{0.5 - length, 0.5 - 0.5 * length, 0.5}));
  query.t_max = from + length * d.pick(std::array{1.0, 2.0});
  const double width = show(d, "width", d.pick(std::array{0x1p-44, 0x1p-40, 0x1p-20, 1.0}));
  const double first = d.pick(std::array{0.0, from + width});
  certified::NormalisedQuery normalised;
  certified::normalise(query, normalised);
  const auto normal = [&](double t) { return std::ldexp(t, -normalised.time); };
  const RoughContact rough =
      certified::rough_contact(normalised, normal(from), normal(first), normal(width));
  suppose(rough.kind != RoughContact::Kind::kOpen);
  show(d, "time", rough.time);
  show(d, "query", query);

  // What begins at `from`, exactly.
  auto patches = linear::exact_patches(query);
  for (MovingPatch<Rational>& patch : patches) patch.positions = patch.at(exact(from));
  const auto contact = linear::first_contact(patches, exact(query.t_max) - exact(from));
  CLAIM(contact.has_value() == (rough.kind == RoughContact::Kind::kProven));
  if (!contact) return;
  // What brings the width to normalised time and back is off by 2^-50 of it.
  const Rational lo = exact(std::ldexp(rough.time, normalised.time)) - exact(from);
  const Rational hi = lo + exact(width) * (1 + power_of_two(-50));
  CLAIM(is_at_least(*contact, lo));
  CLAIM(!is_at_least(*contact, hi));
}

}  // namespace

std::function<void(Draw&)> misses_nothing_linear(std::string method, SearchOptions options) {
  return [=](Draw& d) {
    const Query query = supposed(draw_linear(d));
    const auto contact = supposed(linear::first_contact(query));
    const Answer answer = asked(d, method, query, options);
    if (answer.verdict == Verdict::kUndecided) return;
    show(d, "contact after", contact.lo());
    CLAIM(answer.verdict == Verdict::kHit);
    CLAIM(is_at_least(contact, exact(answer.toi.value())));
  };
}

std::vector<Property> linear_queries_claims() {
  constexpr auto kDerivation = "src/ccd/certified/DERIVATION.md, 7";
  return {
      {"linear.decision_is_proven",
       "Degenerate linear queries are decided, and the independent checker accepts the decision",
       "src/certify/checker/check_linear.hpp", check_decision},
      {"tdibm-c.linear_decided_exactly",
       "Degenerate linear queries, near ones and ones that graze are decided exactly, at a time "
       "within the precision, also with ends",
       kDerivation, check_answer},
      {"tdibm-c.doubles_decide_exactly",
       "Where doubles decide a linear query, exact arithmetic finds the same, at such a time",
       kDerivation, check_doubles},
  };
}

}  // namespace ccdfuzz
