#include <algorithm>

#include "certify/checker/check_turning.hpp"
#include "certify/checker/spin.hpp"
#include "certify/oracle/nearest_points.hpp"
#include "certify/oracle/turned_points.hpp"
#include "generators/generate.hpp"
#include "generators/turning.hpp"
#include "properties/property.hpp"
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
  const Rational t = Rational(d.integer(0, kSteps)) / kSteps;
  show(d, "spin", spin);
  show(d, "t", t);
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
  GeneratorOptions options;
  options.contact = d.pick(kContactClasses);
  options.family = Family::kBodies;
  Query query = generate(options, d).value.query;
  MovingPatch<double>& body = query.patches[d.below(2)];
  body.velocities[0] = {0, 0, 0};
  const Points<double> places = body.positions;
  const double t = static_cast<double>(d.integer(1, 64)) / 64;
  spin_back(body, t, false, d);
  show(d, "query", query);
  const Points<Rational> found = points_at(body, exact(t)).points;
  for (size_t i = 0; i < places.size(); ++i) {
    Rational size = 0;
    for (int k = 0; k < 3; ++k) size += abs(exact(body.positions[i][k]));
    const Rational rounding = size * power_of_two(-24) + power_of_two(-90);
    for (int k = 0; k < 3; ++k) CLAIM(abs(found[i][k] - exact(places[i][k])) <= rounding);
  }
}

/// So many multiples of 1/8, of size `most` at most.
std::vector<double> draw_eighths(Draw& d, size_t count, long most) {
  std::vector<double> numbers;
  for (size_t k = 0; k < count; ++k) {
    numbers.push_back(static_cast<double>(d.integer(-8 * most, 8 * most)) / 8);
  }
  return numbers;
}

/// A turn of few bits about the origin.
BodyTurn draw_small_turn(Draw& d) {
  BodyTurn turn{{}, {}, {0, 0, 0}};
  if (const size_t numbers = d.pick(std::array{3, 4, 2}); numbers == 3) {
    turn.spin = draw_eighths(d, numbers, 2);
  } else {
    turn.from = draw_eighths(d, numbers, 2);
    turn.to = draw_eighths(d, numbers, 2);
  }
  suppose(!fault_of(turn));
  return turn;
}

/// A plane beside a body that turns is accepted for a short time, and refused where it cuts off a
/// point of it then, or later.
void check_plane_beside(Draw& d) {
  const auto point = [&] {
    const std::vector<double> x = draw_eighths(d, 3, 1);
    return Vec3<double>(x[0], x[1], x[2]);
  };
  Query query;
  auto& [body, far] = query.patches;
  body = {Shape::hull(2), {}, {{0, 0, 0}}};
  for (int i = 0; i < 2; ++i) body.positions.push_back(point());
  body.turn = draw_small_turn(d);
  const Vec3<double> normal = point();
  suppose(normal != Vec3<double>(0, 0, 0));
  far = {Shape::hull(1), {1024 * normal}, {{0, 0, 0}}};
  BodyPlanes::Plane plane;
  plane.from = Rational(d.integer(0, 32)) / 64;
  const Rational later = plane.from + Rational(d.integer(1, 32)) / 64;
  for (auto& end : plane.normals) end = {exact(normal[0]), exact(normal[1]), exact(normal[2])};
  show(d, "query", query);
  // In 2^-24 of the step no point goes so far.
  const Rational room = plane.gap = power_of_two(-10);
  const auto highest_at = [&](const Rational& t) {
    const Points<Rational> points = points_at(body, t).points;
    return std::max(dot_of(exact(normal), points[0]), dot_of(exact(normal), points[1]));
  };
  const Rational highest = highest_at(plane.from), highest_later = highest_at(later);
  const auto is_accepted = [&](const Rational& offset, const Rational& until) {
    plane.offsets.fill(offset);
    return check_body_plane(query, plane, until).has_value();
  };
  CLAIM(is_accepted(highest + room, plane.from + power_of_two(-24)));
  CLAIM(!is_accepted(highest - room, plane.from + power_of_two(-24)));
  CLAIM(highest_later <= highest + room || !is_accepted(highest + room, later));
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
       "A plane beside a body that turns is accepted for a short time, and refused where it cuts "
       "off a point of the body",
       "src/certify/checker/check_turning.hpp", check_plane_beside},
  };
}

}  // namespace ccdfuzz
