#include "certify/oracle/nearest_points.hpp"

#include <optional>

namespace ccdfuzz {

namespace {

Vec3<Rational> minus(const Vec3<Rational>& a, const Vec3<Rational>& b) {
  return {Rational(a[0] - b[0]), Rational(a[1] - b[1]), Rational(a[2] - b[2])};
}

/// The place of the point that reaches least along a direction, or, of `sign` −1, furthest.
size_t support(const Points<Rational>& points, const Vec3<Rational>& direction, int sign) {
  size_t best = 0;
  Rational least;
  for (size_t i = 0; i < points.size(); ++i) {
    Rational height = dot_of(points[i], direction);
    if (sign < 0) height = -height;
    if (i == 0 || height < least) {
      best = i;
      least = std::move(height);
    }
  }
  return best;
}

}  // namespace

/// With d_k = ways[k] − ways[0] of the parts, the least vector of the form base + Σ c_k d_k, which
/// is at right angles to all d_k: 1 − Σ c_k, and c_k. With ways[0] as base they are the weights of
/// the least vector in the ways' affine span.
std::vector<Rational> NearestPoints::least_from(const Vec3<Rational>& base) const {
  const size_t n = differences_.size() - 1;
  std::vector<Vec3<Rational>> d;
  for (size_t k = 1; k <= n; ++k) d.push_back(minus(differences_[k].way, differences_[0].way));
  std::vector<std::vector<Rational>> rows(n);
  for (size_t i = 0; i < n; ++i) {
    for (size_t j = 0; j < n; ++j) rows[i].push_back(dot_of(d[i], d[j]));
    rows[i].push_back(-dot_of(d[i], base));
  }
  // No pivot is 0: the matrix is positive definite, as the d_k are independent.
  for (size_t i = 0; i < n; ++i) {
    for (size_t r = 0; r < n; ++r) {
      if (r == i || rows[r][i] == 0) continue;
      const Rational factor = rows[r][i] / rows[i][i];
      for (size_t c = i; c <= n; ++c) rows[r][c] -= factor * rows[i][c];
    }
  }
  std::vector<Rational> weights(n + 1);
  weights[0] = 1;
  for (size_t k = 0; k < n; ++k) {
    weights[k + 1] = rows[k][n] / rows[k][k];
    weights[0] -= weights[k + 1];
  }
  return weights;
}

Vec3<Rational> NearestPoints::rate_of_way(const Vec3<Rational>& velocity) const {
  const std::vector<Rational> shares = least_from(velocity);
  Vec3<Rational> rate = velocity;
  for (size_t k = 1; k < differences_.size(); ++k) {
    const Vec3<Rational> d = minus(differences_[k].way, differences_[0].way);
    for (int i = 0; i < 3; ++i) rate[i] += shares[k] * d[i];
  }
  return rate;
}

/// Moves the weights to the least vector of the parts' span; those that it leaves out first go.
void NearestPoints::settle() {
  for (;;) {
    const std::vector<Rational> goal = least_from(differences_[0].way);
    std::optional<Rational> step;  // how far the weights get before one is 0
    for (size_t k = 0; k < goal.size(); ++k) {
      if (goal[k] > 0) continue;
      const Rational most = differences_[k].weight / (differences_[k].weight - goal[k]);
      if (!step || most < *step) step = most;
    }
    for (size_t k = 0; k < goal.size(); ++k) {
      Rational& weight = differences_[k].weight;
      weight = step ? Rational(weight + *step * (goal[k] - weight)) : goal[k];
    }
    if (!step) return;
    std::erase_if(differences_,
                  [](const Difference& difference) { return difference.weight == 0; });
  }
}

const NearestPoints::Found& NearestPoints::operator()(const Points<Rational>& from,
                                                      const Points<Rational>& to) {
  if (found_.weights[0].size() != from.size() || found_.weights[1].size() != to.size()) {
    differences_ = {{{0, 0}, {}, 1}};
  }
  for (Difference& difference : differences_)
    difference.way = minus(to[difference.places[1]], from[difference.places[0]]);
  for (;;) {
    settle();
    Vec3<Rational>& way = found_.way;
    way = {0, 0, 0};
    for (const Difference& difference : differences_) {
      for (int k = 0; k < 3; ++k) way[k] += difference.weight * difference.way[k];
    }
    found_.squared = dot_of(way, way);
    if (found_.squared == 0) break;
    const std::array<size_t, 2> places = {support(from, way, -1), support(to, way, 1)};
    Vec3<Rational> least = minus(to[places[1]], from[places[0]]);
    if (dot_of(least, way) >= found_.squared) break;
    differences_.push_back({places, std::move(least), 0});
  }
  found_.weights[0].assign(from.size(), 0);
  found_.weights[1].assign(to.size(), 0);
  for (const Difference& difference : differences_) {
    for (size_t s = 0; s < 2; ++s) found_.weights[s][difference.places[s]] += difference.weight;
  }
  return found_;
}

}  // namespace ccdfuzz
