#include "properties/draw_weighted.hpp"

#include <cmath>

#include "bezier/exact_patch.hpp"
#include "fuzz/mutator/exact_moves.hpp"
#include "generators/draw_patch.hpp"
#include "properties/property.hpp"

namespace ccdfuzz {

namespace {

std::vector<int> draw_exponents(Draw& choices, std::size_t count, int most) {
  std::vector<int> exponents(count);
  for (int& e : exponents) e = static_cast<int>(choices.integer(-most, most));
  return exponents;
}

/// Any weights where they have no part in the contact.
void draw_free_weights(Draw& choices, Contact& q, std::size_t side) {
  MovingPatch<double>& patch = q.query.patches[side];
  const std::vector<Dyadic> at_contact = q.weights(static_cast<int>(side));
  const std::vector<double> weights = draw_patch_weights(choices, patch.weights.size());
  for (std::size_t i = 0; i < weights.size(); ++i) {
    if (at_contact[i].sign() == 0) patch.weights[i] = weights[i];
  }
}

Contact draw_pulled(Draw& choices) {
  Contact q = supposed(contact_of(supposed(draw_contact(choices, {-2, 2, 3}))));
  const std::uint64_t sides = 1 + choices.choose(2);
  for (std::size_t s = 0; s < 2; ++s) {
    const std::size_t count = q.query.patches[s].positions.size();
    if ((sides >> s & 1) == 0 || count == 1) continue;
    suppose(pull_by_weights(q, static_cast<int>(s), draw_exponents(choices, count, 3)));
    draw_free_weights(choices, q, s);
  }
  return q;
}

int top_of(const Dyadic& x) {
  return static_cast<int>(mpz_sizeinbase(x.mantissa().get_mpz_t(), 2) + x.exponent());
}

/// Places whose weighted sum is 0: pairs of control points go opposite ways, each by the weight of
/// the other.
Points<Dyadic> draw_balanced(Draw& choices, const std::vector<Dyadic>& weights) {
  Points<Dyadic> places(weights.size());
  for (std::size_t i = 0; i < weights.size(); ++i) {
    if (weights[i].sign() == 0) places[i] = choices.vector(4, -2);
  }
  for (std::size_t left = weights.size(); left > 1; --left) {
    const std::size_t i = choices.below(weights.size()), j = choices.below(weights.size());
    if (i == j || weights[i].sign() == 0 || weights[j].sign() == 0) continue;
    const int unit = std::max(top_of(weights[i]), top_of(weights[j]));
    const Vec3<Dyadic> way = choices.vector(3, -1);
    for (int k = 0; k < 3; ++k) {
      places[i][k] += way[k] * weights[j].scaled(-unit);
      places[j][k] -= way[k] * weights[i].scaled(-unit);
    }
  }
  return places;
}

Contact draw_balanced_contact(Draw& choices) {
  Contact q;
  q.t = choices.pick(
      std::array{Dyadic(0), Dyadic(1), Dyadic(Integer(1), -1), Dyadic(Integer(3), -2)});
  q.query.t_max = choices.coin() ? 1 : *q.t.to_double_exactly();
  for (std::size_t s = 0; s < 2; ++s) {
    MovingPatch<double>& patch = q.query.patches[s];
    patch.shape = draw_shape(choices, 3);
    q.uv[s] = draw_uv(choices, patch.shape, 3);
    const auto count = static_cast<std::size_t>(patch.shape.control_count());
    if (choices.choose(3) != 3) patch.weights = draw_patch_weights(choices, count);
    const Points<Dyadic> places = draw_balanced(choices, q.weights(static_cast<int>(s)));
    Points<Dyadic> positions(count), velocities(count);
    for (std::size_t i = 0; i < count; ++i) {
      velocities[i] = choices.vector(4, -2);
      for (int k = 0; k < 3; ++k) positions[i][k] = places[i][k] - q.t * velocities[i][k];
    }
    patch.positions = supposed(to_doubles(positions));
    patch.velocities = supposed(to_doubles(velocities));
  }
  return q;
}

/// A rational tensor(2, 2), of weights 1, 1, 2 and their products: the part of the sphere about the
/// origin in the octant of these signs.
MovingPatch<double> octant(const Vec3<double>& signs, double radius) {
  constexpr std::array<std::array<double, 3>, 3> kCircle = {{{1, 0, 1}, {1, 1, 1}, {0, 1, 2}}};
  MovingPatch<double> patch{Shape::tensor(2, 2), {}, {}};
  for (const auto& [x, y, w] : kCircle) {
    for (const auto& [r, z, v] : kCircle) {
      patch.positions.emplace_back(radius * signs[0] * r * x, radius * signs[1] * r * y,
                                   radius * signs[2] * z);
      patch.weights.push_back(w * v);
    }
  }
  return patch;
}

}  // namespace

Contact draw_weighted_contact(Draw& choices) {
  Contact q = choices.coin() ? draw_balanced_contact(choices) : draw_pulled(choices);
  suppose(is_rational(q.query) && is_valid(q.query));
  for (std::uint64_t left = choices.choose(2); left > 0; --left) {
    if (Contact next = q; change_coordinates(next, choices)) q = std::move(next);
  }
  return q;
}

FirstContact draw_weighted_first_contact(Draw& choices, Query* plain) {
  FirstContact drawn = supposed(draw_first_contact(choices));
  if (plain != nullptr) *plain = drawn.query;
  Case known;
  known.query = drawn.query;
  known.truth.witness = drawn.witness;
  Contact q = supposed(contact_of(known));
  for (std::size_t s = 0; s < 2; ++s) {
    const std::size_t count = q.query.patches[s].positions.size();
    suppose(pull_by_weights(q, static_cast<int>(s), draw_exponents(choices, count, 1)));
    const auto [least, most] =
        std::minmax_element(q.query.patches[s].weights.begin(), q.query.patches[s].weights.end());
    // Control points go away by at most 2; derivatives grow by the square of the ratio.
    drawn.early *= 2 * (*most / *least) * (*most / *least);
  }
  drawn.query = q.query;
  return drawn;
}

RoundContact draw_round_contact(Draw& choices) {
  // Directions whose parameters are rational: 3² + 4² = 5², 5² + 12² = 13², 60² + 25² = 65². On a
  // quarter circle the parameter p has the cosine (1 − p²)/(1 + p²).
  constexpr std::array<std::array<int, 4>, 4> kDirections = {
      {{3, 4, 12, 13}, {4, 3, 12, 13}, {36, 48, 25, 65}, {48, 36, 25, 65}}};
  const auto& [x, y, z, length] = choices.pick(kDirections);
  const Uv<Rational> uv = {Rational(1, x < y ? 2 : 3),
                           length == 13 ? Rational(2, 3) : Rational(1, 5)};
  const auto part = [&] { return choices.coin() ? 1.0 : -1.0; };
  const double sx = part(), sy = part();
  const Vec3<double> signs(sx, sy, part());
  const Vec3<double> direction(signs[0] * x, signs[1] * y, signs[2] * z);
  // At t = 1 the ball is at the origin, and the direction points to where it touches.
  const double radius = length * (1 + static_cast<double>(choices.choose(3)));
  const std::uint64_t gap = choices.choose(3) == 3 ? 1 + choices.choose(1) : 0;
  const double reach = radius / length + static_cast<double>(gap);
  RoundContact out;
  out.t = 1;
  out.uv = uv;
  out.query.separation = static_cast<double>(gap) * length;
  auto& [ball, other] = out.query.patches;
  ball = octant(signs, radius);
  const Vec3<double> foot = reach * direction;
  const std::uint64_t kind = choices.choose(2);
  if (kind == 0) {
    other = {Shape::point(), {foot}, {}};
  } else if (kind == 1) {
    const double other_radius = length * (1 + static_cast<double>(choices.choose(3)));
    other = octant(-signs, other_radius);
    const double apart = reach + other_radius / length;
    for (Vec3<double>& p : other.positions) p += apart * direction;
  } else {
    const Vec3<double> along(-direction[1], direction[0], 0);
    const Vec3<double> up(-direction[0] * z * signs[2], -direction[1] * z * signs[2],
                          static_cast<double>(x * x + y * y));
    other.shape = Shape::triangle(1);
    for (const auto& [a, b] : {std::array{-3, -1}, std::array{3, -1}, std::array{0, 2}}) {
      other.positions.push_back(foot + a * along + b * up);
    }
  }
  // They approach: the relative velocity has a part along the direction.
  Vec3<double> velocity(0, 0, 0), drift(0, 0, 0);
  for (int k = 0; k < 3; ++k) {
    velocity[k] = static_cast<double>(choices.integer(-8, 8)) + direction[k] * 0.25;
    drift[k] = static_cast<double>(choices.integer(-4, 4));
  }
  suppose(velocity.dot(direction) > 0.125 * length * velocity.norm());
  ball.velocities.assign(ball.positions.size(), velocity + drift);
  other.velocities.assign(other.positions.size(), drift);
  for (Vec3<double>& p : ball.positions) p -= velocity + drift;
  for (Vec3<double>& p : other.positions) p -= drift;
  out.query.t_max = 2;
  return out;
}

}  // namespace ccdfuzz
