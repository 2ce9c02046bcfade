#include <algorithm>
#include <cmath>

#include "certify/checker/check_case.hpp"
#include "certify/oracle/body_depth.hpp"
#include "certify/oracle/feature_depth.hpp"
#include "certify/oracle/oracle.hpp"
#include "certify/oracle/outcome_of.hpp"
#include "generators/draw_patch.hpp"
#include "generators/similar.hpp"
#include "properties/draw_linear.hpp"
#include "properties/show.hpp"

namespace ccdfuzz {

namespace {

/// A box with edges along the axes, in whole numbers.
struct WholeBox {
  std::array<std::int64_t, 3> low{}, high{};
};

WholeBox draw_whole_box(Draw& d) {
  WholeBox box;
  for (std::size_t k = 0; k < 3; ++k) {
    box.low[k] = d.integer(-4, 4);
    box.high[k] = box.low[k] + d.integer(0, 4);
  }
  return box;
}

MovingPatch<double> body_of(const WholeBox& box, const Vec3<double>& velocity, double radius) {
  Points<double> corners;
  for (std::size_t corner = 0; corner < 8; ++corner) {
    Vec3<double> p;
    for (std::size_t k = 0; k < 3; ++k) {
      p[static_cast<long>(k)] =
          static_cast<double>((corner >> k) % 2 == 0 ? box.low[k] : box.high[k]);
    }
    if (std::ranges::find(corners, p) == corners.end()) corners.push_back(p);
  }
  MovingPatch<double> body;
  body.shape = Shape::hull(static_cast<int>(corners.size()));
  body.velocities = {velocity};
  body.positions = std::move(corners);
  body.radius = radius;
  return body;
}

/// What a box sweeps over along an axis is a box. Two of them overlap by the least overlap along an
/// axis. If they do not, they are as far apart as their gaps along all axes say.
void check_depth_of_boxes(Draw& d) {
  const std::array<WholeBox, 2> boxes = {draw_whole_box(d), draw_whole_box(d)};
  const std::size_t axis = d.below(3), mover = d.below(2);
  const double way = d.integer(-4, 4);
  const auto radius = [&] { return d.integer(0, 8) / 4.0; };
  const double first = radius(), second = radius();
  Vec3<double> velocity(0, 0, 0);
  velocity[static_cast<long>(axis)] = way;
  Case known;
  Query& query = known.query;
  query.t_max = 1;
  query.patches = {body_of(boxes[0], mover == 0 ? velocity : Vec3<double>(0, 0, 0), first),
                   body_of(boxes[1], mover == 1 ? velocity : Vec3<double>(0, 0, 0), second)};
  known.truth = decide(query).truth;
  show(d, "case", known);

  const auto depth_of = [&](double until) {
    double least = HUGE_VAL, gaps = 0;  // squared, exact
    for (std::size_t k = 0; k < 3; ++k) {
      const WholeBox &swept = boxes[mover], &rest = boxes[1 - mover];
      const double moved = k == axis ? way * until : 0;
      const auto low = static_cast<double>(swept.low[k]) + std::min(moved, 0.0) -
                       static_cast<double>(rest.high[k]);
      const auto high = static_cast<double>(swept.high[k]) + std::max(moved, 0.0) -
                        static_cast<double>(rest.low[k]);
      const double overlap = std::min(high, -low);
      least = std::min(least, overlap);
      if (overlap < 0) gaps += overlap * overlap;
    }
    return least >= 0 ? first + second + least : std::max(0.0, first + second - std::sqrt(gaps));
  };
  const double depth = show(d, "depth", depth_of(query.t_max));
  const std::optional<double> got = depth_until(query, query.t_max);
  // Numbers of at most 16, in binary64, and few roundings.
  constexpr double kRounding = 0x1p-44;
  CLAIM(got && *got <= depth + kRounding && *got >= depth - kRounding);
  CLAIM(known.truth.collides.has_value());
  if (!*known.truth.collides) return;

  const CheckedCase checked = value_or_throw(check_case(known));
  const Rational contact = *checked.contact_by();
  const double toi = d.integer(0, 4) / 4.0;
  // A hit is late by no more than the way since the contact.
  const Rational late_by = std::abs(way) * (exact(show(d, "toi", toi)) - contact);
  const auto claim_judged = [&](const Answer& said, double deep, int side, Outcome wrong) {
    // Depths are fourths, or far enough from the next eighths, of which the tolerance is one.
    AnswerTerms terms;
    terms.depth_tolerance = show(d, "tolerance", std::abs(std::floor(4 * deep) / 4 + side / 8.0));
    const bool is_right =
        deep < terms.depth_tolerance || (said.toi && late_by <= exact(terms.depth_tolerance));
    const Outcome outcome = show(d, "outcome", outcome_of(checked, said, terms, false));
    CLAIM(outcome == (is_right ? Outcome::kCorrect : wrong));
  };
  for (const int side : {-1, 1}) {
    claim_judged(Answer::miss(), depth, side, Outcome::kMissed);
    claim_judged(Answer::hit(toi), depth_of(toi), side, Outcome::kLate);
  }
}

/// Turns an arm about z: evenly by a spin, or nearly so by a quaternion. Returns the angle at t, in
/// [0, 1].
double turn_arm(Draw& d, double t, BodyTurn& turn) {
  if (d.coin()) {
    const int speed = d.integer(1, 8);
    turn.spin = {0, 0, 1.0 * speed};
    return speed * t;
  }
  const double most = d.integer(4, 8) / 16.0;
  turn.from = {1, 0, 0, -most};
  turn.to = {1, 0, 0, most};
  return 2 * std::atan(most * (2 * t - 1));
}

/// The axis of an arm that turns about its end comes through the centre of a ball. They overlap by
/// both radii and their separation then, however short that is, and never by more.
void check_depth_of_arms(Draw& d) {
  const int length = d.integer(1, 8), way = d.integer(1, length);
  const double arm = d.integer(0, 4) / 16.0, ball = d.integer(1, 8) / 16.0;
  const double t = d.integer(1, 63) / 64.0;
  MovingPatch<double> turning{Shape::hull(2), {{0, 0, 0}, {1.0 * length, 0, 0}}, {{0, 0, 0}}};
  const double angle = turn_arm(d, t, turning.turn.emplace());
  MovingPatch<double> resting{
      Shape::hull(1), {{way * std::cos(angle), way * std::sin(angle), 0}}, {{0, 0, 0}}};
  turning.radius = arm;
  resting.radius = ball;
  const Rational share = Rational(way) / length;
  Witness witness{exact(t), {}, {{{1 - share, share}, {1}}}};
  if (d.coin()) {
    std::ranges::reverse(turning.positions);
    std::ranges::reverse(witness.weights[0]);
  }
  Case known;
  Query& query = known.query = {{turning, resting}, 1};
  query.separation = d.integer(0, 2) / 16.0;
  known.truth.witness = witness;
  show(d, "case", known);
  const double depth = show(d, "depth", arm + ball + query.separation);
  const std::optional<double> got = depth_until(query, query.t_max);
  // The centre is off by a few roundings of numbers of at most 8.
  constexpr double kRounding = 0x1p-44;
  CLAIM(got && *got <= depth + kRounding && *got >= depth / 2);
  const CheckedCase checked = value_or_throw(check_case(known));
  const auto outcome_of_miss = [&](double tolerance) {
    return show(d, "outcome",
                outcome_of(checked, Answer::miss(), {.depth_tolerance = tolerance}, false));
  };
  CLAIM(outcome_of_miss(depth * 7 / 8) == Outcome::kMissed);
  // It would have to be moved by more than it overlaps at any time.
  CLAIM(outcome_of_miss(depth * 9 / 8) == Outcome::kUnknown);
}

double depth_of_feature(const Query& query) {
  return feature_depth({query, decide(query).truth, {}, {}}, query.t_max);
}

/// Whoever moves a vertex or an edge by less than its depth, in any direction, leaves a contact in
/// that time. At another scale the depth is that many times as much.
void check_depth_of_features(Draw& d) {
  Query query = draw_touching_at_half(
      d, [](Draw& choices) { return draw_integers(choices, 4); }, true);
  query.t_max = d.integer(5, 8) / 8.0;
  show(d, "query", query);
  const double depth = show(d, "depth", depth_of_feature(query));
  suppose(depth >= 0x1p-30);  // coordinates are of few bits: to round them moves them by far less
  const int exponent = show(d, "exponent", d.integer(-900, 900));
  const Query larger = supposed(similar(query, {.space = exponent}));
  const double scaled = show(d, "scaled", std::ldexp(depth_of_feature(larger), -exponent));
  CLAIM(std::abs(scaled - depth) <= 0x1p-50 * depth);
  Vec3<double> move;  // of at most √3·73 < 127
  for (double& x : move) x = d.integer(-73, 73);
  for (Vec3<double>& p : query.patches[0].positions) p += move / 128 * depth;
  show(d, "moved", query.patches[0].positions);
  CLAIM(decide(query).truth.collides == true);
}

}  // namespace

std::vector<Property> depths_claims() {
  return {
      {"bodies.depth_of_boxes",
       "Two boxes, one of which moves along an axis, are as deep as their corners say; a miss or a "
       "late hit is right iff that is within the tolerance",
       "src/certify/oracle/body_depth.hpp", check_depth_of_boxes},
      {"bodies.depth_of_arms",
       "However shortly an arm passes through a ball, it is found to be as deep as both radii",
       "src/certify/oracle/body_depth.hpp", check_depth_of_arms},
      {"features.depth",
       "A vertex or an edge that is moved by less than its depth still touches; depths scale",
       "src/certify/oracle/feature_depth.hpp", check_depth_of_features},
  };
}

}  // namespace ccdfuzz
