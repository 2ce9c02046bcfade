#include "properties/draw_linear.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "bezier/exact_patch.hpp"
#include "case/scale.hpp"
#include "generators/shaped/contact_scene.hpp"
#include "properties/property.hpp"

namespace ccdfuzz {

namespace {

using Vector = Vec3<Dyadic>;

/// A patch of degree 0 or 1: its corners and their velocities, and weights that name a point of it.
struct LinearSide {
  Points<Dyadic> corners, velocities;
  std::vector<Dyadic> weights;

  Vector mean(const Points<Dyadic>& of) const {
    Vector sum = {Dyadic(), Dyadic(), Dyadic()};
    for (std::size_t i = 0; i < of.size(); ++i) sum += of[i] * weights[i];
    return sum;
  }
};

using LinearScene = std::array<LinearSide, 2>;

Vector draw_small_vector(Draw& choices, int dimensions) {
  constexpr int kBits = 2;
  Vector v = {Dyadic(), Dyadic(), Dyadic()};
  for (int k = 0; k < dimensions; ++k) v[k] = choices.dyadic(kBits, -1);
  return v;
}

/// Weights of 1, 2 or 3 corners, multiples of 1/4 with sum 1; often at a corner or on an edge.
std::vector<Dyadic> draw_weights(Draw& choices, std::size_t count) {
  std::vector<Dyadic> weights(count);
  std::int64_t left = 4;
  for (std::size_t i = count - 1; i > 0; --i) {
    const std::int64_t share = choices.integer(0, left);
    weights[i] = Dyadic(static_cast<int>(share)).scaled(-2);
    left -= share;
  }
  weights[0] = Dyadic(static_cast<int>(left)).scaled(-2);
  return weights;
}

LinearSide draw_linear_side(Draw& choices, std::size_t count, int dimensions) {
  LinearSide side;
  for (std::size_t i = 0; i < count; ++i) {
    side.corners.push_back(draw_small_vector(choices, dimensions));
    side.velocities.push_back(draw_small_vector(choices, dimensions));
  }
  if (count > 1 && choices.choose(7) == 7) {  // a corner on another, for good
    side.corners.back() = side.corners[count - 2];
    side.velocities.back() = side.velocities[count - 2];
  }
  if (choices.choose(3) == 3) {  // no motion but that of the first corner
    for (Vector& v : side.velocities) v = side.velocities[0];
  }
  side.weights = draw_weights(choices, count);
  return side;
}

/// The second edge parallel to the first, at all times or at the start.
void make_parallel(Draw& choices, LinearScene& scene) {
  const Dyadic factor = choices.pick(std::array{Dyadic(1), Dyadic(-1), Dyadic(2), Dyadic(1, -1)});
  const bool for_good = !choices.coin();
  const auto follow = [&](const Points<Dyadic>& first, Points<Dyadic>& second) {
    second[1] = second[0] + Vector(first[1] - first[0]) * factor;
  };
  follow(scene[0].corners, scene[1].corners);
  if (for_good) follow(scene[0].velocities, scene[1].velocities);
}

/// Moves the first side so that a point of each side coincides at t. Half of the time the relative
/// velocity is a combination of the first edges of both.
void plant_contact(Draw& choices, const Dyadic& t, LinearScene& scene) {
  auto& [a, b] = scene;
  if (choices.coin()) {
    Vector relative = {Dyadic(), Dyadic(), Dyadic()};
    for (const LinearSide& side : scene) {
      const Dyadic share = Dyadic(choices.integer(-1, 1));
      for (std::size_t i = 1; i < std::min<std::size_t>(side.corners.size(), 2); ++i) {
        const Vector edge = side.corners[i] - side.corners[0];
        const Vector turn = side.velocities[i] - side.velocities[0];
        relative += Vector(edge + turn * t) * share;
      }
    }
    const Vector change = relative + b.mean(b.velocities) - a.mean(a.velocities);
    for (Vector& v : a.velocities) v += change;
  }
  const Vector gap =
      b.mean(b.corners) + b.mean(b.velocities) * t - a.mean(a.corners) - a.mean(a.velocities) * t;
  for (Vector& p : a.corners) p += gap;
}

}  // namespace

Shape linear_shape(std::size_t corners) {
  if (corners == 1) return Shape::point();
  return corners == 2 ? Shape::curve(1) : Shape::triangle(1);
}

Result<Query> draw_linear(Draw& choices) {
  using Counts = std::array<std::size_t, 2>;
  const Counts counts = choices.pick(
      std::array<Counts, 8>{{{2, 2}, {1, 3}, {2, 2}, {1, 3}, {2, 2}, {3, 1}, {1, 2}, {1, 1}}});
  const int dimensions = choices.pick(std::array{3, 3, 3, 2, 2, 1});
  LinearScene scene = {draw_linear_side(choices, counts[0], dimensions),
                       draw_linear_side(choices, counts[1], dimensions)};
  if (counts == Counts{2, 2} && choices.choose(3) == 3) make_parallel(choices, scene);
  const Dyadic t = choices.pick(std::array{Dyadic(1), Dyadic(), Dyadic(1, -1), Dyadic(3, -2)});
  if (choices.choose(3) != 3) plant_contact(choices, t, scene);
  // Turns and shears everything, and gives it a common velocity.
  Placement placement;
  placement.frame = draw_frame_near_axes(choices, 1);
  placement.drift = draw_small_vector(choices, 3);
  placement.exponent.fill(choices.coin() ? choices.integer(-1000, 900) : 0);

  Query query;
  for (std::size_t s = 0; s < 2; ++s) {
    const auto& [corners, velocities, weights] = scene[s];
    const ContactSide side{linear_shape(counts[s]), {}, corners, velocities};
    const auto patch = to_doubles(placed(side, placement, Dyadic()));
    if (!patch) return input_error("", "a number is not a double");
    query.patches[s] = *patch;
  }
  if (choices.coin()) {
    for (MovingPatch<double>& patch : query.patches) {
      for_each_coordinate(patch, [&](double& x) {
        if (choices.choose(7) == 7) x = choices.nudged(x, 1);
      });
    }
  }
  const double t_contact = *t.to_double_exactly();
  query.t_max = choices.pick(std::array{1.0, t_contact, 2.0, t_contact + 0x1p-30});
  return query;
}

Query draw_linear_apart(Draw& choices) {
  Query query = supposed(draw_linear(choices));
  const double size = largest_coordinate_at_ends(query);
  const int exponent = -choices.integer(0, 12);
  query.separation = size * std::ldexp(choices.pick(std::array{1.0, 1.25}), exponent);
  suppose(is_valid(query) && query.separation > 0x1p-900 && size < 0x1p900);
  return query;
}

Query draw_touching_at_half(Draw& choices, DrawVector* draw_vector, bool is_rigid) {
  constexpr std::array kShares = {0.0, 1.0, 0.5, 0.25, 0.375, 0.6875};
  const bool edges = choices.coin();
  Query query;
  query.t_max = 1;
  std::array<Vec3<double>, 2> at;
  for (std::size_t s = 0; s < 2; ++s) {
    MovingPatch<double>& patch = query.patches[s];
    patch.shape = linear_shape(edges ? 2 : 1 + 2 * s);
    at[s] = {0, 0, 0};
    double left = 1;
    for (int i = patch.shape.control_count() - 1; i >= 0; --i) {
      const Vec3<double> p = draw_vector(choices);
      const bool is_alike = is_rigid && !patch.velocities.empty();
      const Vec3<double> v = is_alike ? patch.velocities[0] : draw_vector(choices);
      const double share = i == 0 ? left : choices.pick(kShares) * left;
      left -= share;
      at[s] += share * (p + 0.5 * v);
      patch.positions.push_back(p);
      patch.velocities.push_back(v);
    }
  }
  for (Vec3<double>& p : query.patches[0].positions) p += at[1] - at[0];
  return query;
}

}  // namespace ccdfuzz
