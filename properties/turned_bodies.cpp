#include <algorithm>

#include "bezier/exact_patch.hpp"
#include "certify/checker/check_bodies.hpp"
#include "certify/checker/check_turning.hpp"
#include "certify/checker/spin.hpp"
#include "certify/oracle/rational_roots.hpp"
#include "certify/oracle/turned_points.hpp"
#include "generators/draw_patch.hpp"
#include "generators/turning.hpp"
#include "numeric/products.hpp"
#include "properties/planted_bodies.hpp"
#include "properties/show.hpp"

namespace ccdfuzz {

namespace {

/// The quaternion of a spin is the square of that of half of the time. At a short time it is (1,
/// u), u half of its angle along its axis, but for |u|².
void check_quaternion_of_spin(Draw& d) {
  std::vector<double> spin;
  for (int k = 0; k < 3; ++k) spin.push_back(*d.dyadic(24, -22).to_double_exactly());
  suppose(!fault_of(BodyTurn{{}, {}, {0, 0, 0}, spin}));
  constexpr long kSteps = 1 << 20;
  const Rational t = show(d, "t", Rational(d.integer(0, kSteps)) / kSteps);
  show(d, "spin", spin);
  Work work(kMostWork);
  const auto at = [&](const Rational& time) { return quaternion_of_spin(spin, time, work); };
  const auto [w, x, y, z] = at(t);
  const auto [cosine, a, b, c] = at(t / 2);
  const Rational off = 8 * spin_error();
  CLAIM(abs(w - (cosine * cosine - a * a - b * b - c * c)) <= off);
  CLAIM(abs(x - 2 * cosine * a) <= off);
  CLAIM(abs(y - 2 * cosine * b) <= off);
  CLAIM(abs(z - 2 * cosine * c) <= off);
  const Rational shortly = power_of_two(-40);
  const auto start = at(shortly);
  const Rational square = power_of_two(-76);  // |u| ≤ 8/2 · 2^-40
  CLAIM(abs(start[0] - 1) <= square);
  for (size_t k = 0; k < 3; ++k) {
    CLAIM(abs(start[k + 1] - exact(spin[k]) * shortly / 2) <= square * power_of_two(-38));
  }
}

/// A body that was turned back comes to its place, but for the rounding of its points to floats.
void check_spun_back(Draw& d) {
  Query query = draw_planted(d, CaseKind::kRP).query;
  MovingPatch<double>& body = query.patches[d.below(2)];
  body.velocities[0] = {0, 0, 0};
  const Points<double> places = body.positions;
  const double t = d.integer(1, 64) / 64.0;
  spin_back(body, t, false, kFastestSpin, d);
  show(d, "query", query);
  const Points<Rational> found = points_at(body, exact(t)).rational();
  for (size_t i = 0; i < places.size(); ++i) {
    Rational size = 0;
    for (int k = 0; k < 3; ++k) size += abs(exact(body.positions[i][k]));
    const Rational rounding = size * power_of_two(-24) + power_of_two(-90);
    for (int k = 0; k < 3; ++k) CLAIM(abs(found[i][k] - exact(places[i][k])) <= rounding);
  }
}

/// So many multiples of 1/8, of size `most` at most.
std::vector<double> draw_eighths(Draw& d, size_t count, int most) {
  std::vector<double> numbers;
  for (size_t k = 0; k < count; ++k) {
    numbers.push_back(d.integer(-8 * most, 8 * most) / 8.0);
  }
  return numbers;
}

Vec3<double> draw_point(Draw& d) {
  return draw_integers(d, 8) / 8;
}

/// A turn of few bits.
BodyTurn draw_small_turn(Draw& d) {
  BodyTurn turn{{}, {}, draw_point(d)};
  if (const size_t numbers = d.pick(std::array{3, 4, 2}); numbers == 3) {
    turn.spin = draw_eighths(d, numbers, 2);
  } else {
    turn.from = draw_eighths(d, numbers, 2);
    turn.to = draw_eighths(d, numbers, 2);
  }
  suppose(!fault_of(turn));
  return turn;
}

/// A plane on either side of a body that turns is accepted for a short time. It is refused where it
/// cuts off a point of it then, or later, or between two times at which it does not. It is refused
/// with a gap that is no larger than the body's radius, too.
void check_plane_beside(Draw& d) {
  Query query;
  auto& [body, far] = query.patches;
  body = {Shape::hull(2), {}, {draw_point(d)}};
  for (int i = 0; i < 2; ++i) body.positions.push_back(draw_point(d));
  body.radius = d.integer(0, 8) / 8.0;
  body.turn = draw_small_turn(d);
  const Vec3<double> normal = draw_point(d);
  suppose(normal != Vec3<double>(0, 0, 0));
  far = {Shape::hull(1), {1024 * normal}, {{0, 0, 0}}};
  BodyPlanes::Plane plane;
  plane.from = Rational(d.integer(0, 32)) / 64;
  const Rational later = plane.from + Rational(d.integer(1, 32)) / 64;
  const bool is_first = d.coin();
  for (auto& end : plane.normals) {
    for (int k = 0; k < 3; ++k)
      end[static_cast<size_t>(k)] = exact(is_first ? normal[k] : -normal[k]);
  }
  Query asked = query;
  if (!is_first) std::swap(asked.patches[0], asked.patches[1]);
  show(d, "query", asked);
  // In 2^-24 of the step no point goes so far.
  const Rational room = power_of_two(-10);
  const Rational kept = exact(body.radius) * root_above(dot(exact(normal), exact(normal)));
  plane.gap = kept + room;
  const auto highest_at = [&](const Rational& t) {
    const Points<Rational> points = points_at(body, t).rational();
    return std::max(dot(exact(normal), points[0]), dot(exact(normal), points[1]));
  };
  const Rational highest = highest_at(plane.from), highest_later = highest_at(later);
  const auto is_accepted = [&](const Rational& first, const Rational& last, const Rational& until) {
    plane.offsets = {first, last};
    for (Rational& offset : plane.offsets) {
      if (!is_first) offset = -offset - plane.gap;
    }
    return check_body_plane(asked, plane, until).has_value();
  };
  const Rational shortly = plane.from + power_of_two(-24);
  const Rational above = highest + room, below = highest - room;
  CLAIM(is_accepted(above, above, shortly));
  CLAIM(!is_accepted(below, below, shortly));
  CLAIM(highest_later <= above || !is_accepted(above, above, later));
  constexpr long kParts = 8;
  const Rational share = Rational(d.integer(1, kParts - 1)) / kParts;
  const Rational little = power_of_two(-d.integer(1, 20));
  const Rational height = (1 - share) * highest + share * highest_later + little;
  // Where |q| is not rational, points are within 2^-96 of their distance from the centre.
  const Rational rounding = power_of_two(-60);
  CLAIM(highest_at(plane.from + share * (later - plane.from)) <= height + rounding ||
        !is_accepted(highest + little, highest_later + little, later));
  plane.gap = exact(body.radius * normal.cwiseAbs().maxCoeff());
  CLAIM(!is_accepted(above, above, shortly));
}

/// About a point within a body that spins is a ball, which the nearest of its faces' planes
/// touches. At the start a point in that ball touches the body. None outside of it is seen to. In
/// the plane z = 0 it is a disc, and edges are in place of faces.
void check_ball_within(Draw& d) {
  const bool in_plane = d.coin();
  const size_t count = in_plane ? 3 : 4;
  const auto draw_place = [&] {
    const Vec3<double> p = draw_point(d);
    return in_plane ? Vec3<double>(p[0], p[1], 0) : p;
  };
  Query query;
  auto& [body, other] = query.patches;
  body = {Shape::hull(static_cast<int>(count)), {}, {{0, 0, 0}}};
  for (size_t i = 0; i < count; ++i) body.positions.push_back(draw_place());
  body.turn = BodyTurn{{}, {}, {0, 0, 0}, draw_eighths(d, 3, 2)};
  if (in_plane) body.turn->spin[0] = body.turn->spin[1] = 0;
  Witness witness{0, {}, {{{}, {Rational(1)}}}};
  std::vector<Rational>& weights = witness.weights[0];
  Rational rest = 1;
  for (size_t i = 1; i < count; ++i) rest -= weights.emplace_back(Rational(d.integer(1, 4)) / 16);
  weights.push_back(rest);
  const Points<Rational> corners = exact_points<Rational>(body.positions);
  Vec3<Rational> inside = {0, 0, 0};
  for (size_t i = 0; i < count; ++i) inside += weights[i] * corners[i];
  Vec3<double> place = draw_place() / 4;
  for (int k = 0; k < 3; ++k) place[k] += *to_double_exactly(inside[k]);
  other = {Shape::hull(1), {place}, {{0, 0, 0}}};
  show(d, "query", query);
  show(d, "weights", weights);
  std::optional<Rational> nearest;  // plane, its distance squared
  for (size_t i = 0; i < count; ++i) {
    const auto way = [&](size_t to) {
      return Vec3<Rational>(corners[to % count] - corners[(i + 1) % count]);
    };
    const Vec3<Rational> normal =
        cross(way(i + 2), in_plane ? Vec3<Rational>(0, 0, 1) : way(i + 3));
    suppose(dot(normal, way(i)) != 0);
    const Rational height = dot(normal, Vec3<Rational>(inside - corners[(i + 1) % count]));
    const Rational squared = height * height / dot(normal, normal);
    nearest = nearest ? std::min(*nearest, squared) : squared;
  }
  const Vec3<Rational> way = exact(place) - inside;
  const Rational squared = dot(way, way);
  const bool is_accepted = check_body_contact(query, witness).has_value();
  CLAIM(squared <= *nearest || !is_accepted);
  CLAIM(squared > *nearest * (1 - power_of_two(-20)) || is_accepted);
}

/// A point that turns by cosine and sine is found in its direction from the centre, which is exact.
/// It is no farther from the truth than it says, as ways from the axis keep their length.
void check_turned_point(Draw& d) {
  const MovingPatch<double> point{Shape::hull(1), {draw_point(d)}, {{0, 0, 0}}};
  Query query{{point, point}};
  MovingPatch<double>& body = query.patches[0];
  body.turn = BodyTurn{draw_eighths(d, 2, 2), draw_eighths(d, 2, 2), draw_point(d)};
  suppose(!fault_of(*body.turn));
  show(d, "query", query);
  const Rational t = show(d, "t", Rational(d.integer(0, 64)) / 64);
  Work work(kMostWork);
  const auto found = moved_point(body, exact(body.positions[0]), t, work);
  const auto flat = [](const Vec3<Rational>& v) { return Vec3<Rational>(v[0], v[1], 0); };
  const Vec3<Rational> centre = exact(body.turn->centre);
  const Vec3<Rational> way = flat(exact(body.positions[0]) - centre);
  const Vec3<Rational> turned = flat(found.point - centre);
  std::array<Rational, 2> q;
  for (size_t i = 0; i < 2; ++i) {
    q[i] = (1 - t) * exact(body.turn->from[i]) + t * exact(body.turn->to[i]);
  }
  const Vec3<Rational> along(q[0] * way[0] - q[1] * way[1], q[1] * way[0] + q[0] * way[1], 0);
  CLAIM(cross(along, turned)[2] == 0 && dot(along, turned) >= 0);
  CLAIM(found.point[2] == exact(body.positions[0][2]));
  const Rational longest = root_above(dot(turned, turned)) + found.error;
  CLAIM(dot(turned, turned) <= dot(way, way) && dot(way, way) <= longest * longest);
}

}  // namespace

std::vector<Property> turned_bodies_claims() {
  return {
      {"turning.quaternion_of_spin",
       "The quaternion of a spin is enclosed: it is the square of that of half of the time, and "
       "begins as its angle does",
       "src/certify/checker/spin.hpp", check_quaternion_of_spin},
      {"turning.planted_back",
       "Points of a planted body that spins come to their places at the contact, but for a "
       "rounding",
       "generators/turning.hpp", check_spun_back},
      {"turning.plane_beside",
       "A plane on either side of a body that turns is accepted for a short time, and refused "
       "where it cuts off a point of the body at one of its ends or between them, or its gap is no "
       "larger than the radius",
       "src/certify/checker/check_turning.hpp", check_plane_beside},
      {"turning.ball_within",
       "A body that spins holds the ball about a point in it that its faces' planes touch, and no "
       "larger one; in a plane it is the disc that its edges touch",
       "src/certify/checker/check_bodies.hpp", check_ball_within},
      {"turning.point_enclosed",
       "A point that turns by cosine and sine is known within the error that is said, where |q| is "
       "not rational, too",
       "src/certify/checker/check_turning.hpp", check_turned_point},
  };
}

}  // namespace ccdfuzz
