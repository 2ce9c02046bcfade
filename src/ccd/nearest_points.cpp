#include "ccd/nearest_points.hpp"
#include "numeric/products.hpp"

namespace ccdfuzz {

namespace {

/// Makes the number a multiple of the denominators.
void add_denominators(const Vec3<Rational>& v, Integer& common) {
  for (int k = 0; k < 3; ++k) common = lcm(common, v[k].get_den());
}

Vec3<Integer> scaled_by(const Integer& scale, const Vec3<Rational>& v) {
  Vec3<Integer> out;
  for (int k = 0; k < 3; ++k) out[k] = v[k].get_num() * Integer(scale / v[k].get_den());
  return out;
}

Rational fraction(const Integer& x, const Integer& y) {
  return Rational(x) / y;
}

/// The place of the point that reaches least along a direction, or, of `sign` −1, furthest.
size_t support(const Points<Integer>& points, const Vec3<Integer>& direction, int sign) {
  size_t best = 0;
  Integer least;
  for (size_t i = 0; i < points.size(); ++i) {
    Integer height = dot(points[i], direction);
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
NearestPoints::Shares NearestPoints::least_from(const Vec3<Integer>& base) const {
  const size_t n = differences_.size() - 1;
  std::vector<Vec3<Integer>> d;
  for (size_t k = 1; k <= n; ++k) d.emplace_back(differences_[k].way - differences_[0].way);
  std::vector<std::vector<Integer>> rows(n);
  for (size_t i = 0; i < n; ++i) {
    for (size_t j = 0; j < n; ++j) rows[i].push_back(dot(d[i], d[j]));
    rows[i].push_back(-dot(d[i], base));
  }
  // Bareiss: entries are minors, so each division by the last pivot is exact. No pivot is 0: the
  // matrix is positive definite, as the d_k are independent.
  Shares shares{{}, 1};
  for (size_t i = 0; i < n; ++i) {
    for (size_t r = 0; r < n; ++r) {
      if (r == i) continue;
      for (size_t c = 0; c <= n; ++c) {
        if (c == i) continue;
        rows[r][c] = rows[i][i] * rows[r][c] - rows[r][i] * rows[i][c];
        mpz_divexact(rows[r][c].get_mpz_t(), rows[r][c].get_mpz_t(), shares.total.get_mpz_t());
      }
      rows[r][i] = 0;
    }
    shares.total = rows[i][i];
  }
  shares.of.push_back(shares.total);
  for (size_t k = 0; k < n; ++k) {
    shares.of[0] -= rows[k][n];
    shares.of.push_back(rows[k][n]);
  }
  return shares;
}

Vec3<Rational> NearestPoints::rate_of_way(const Vec3<Rational>& velocity) const {
  Integer scale = 1;
  add_denominators(velocity, scale);
  const Vec3<Integer> base = scaled_by(scale, velocity);
  const Shares shares = least_from(base);
  Vec3<Integer> rate = shares.total * base;
  for (size_t k = 1; k < differences_.size(); ++k) {
    rate += shares.of[k] * (differences_[k].way - differences_[0].way);
  }
  const Integer whole = shares.total * scale;
  return {fraction(rate[0], whole), fraction(rate[1], whole), fraction(rate[2], whole)};
}

/// Moves the weights to the least vector of the parts' span; those that it leaves out first go.
void NearestPoints::settle() {
  for (;;) {
    Shares goal = least_from(differences_[0].way);
    Integer step = 0, whole = 0;  // how far the weights get before one is 0: step / whole
    for (size_t k = 0; k < goal.of.size(); ++k) {
      if (goal.of[k] > 0) continue;
      const Integer here = differences_[k].weight * goal.total;
      const Integer way = here - goal.of[k] * total_;
      if (whole == 0 || here * whole < step * way) step = here, whole = way;
    }
    if (whole == 0) {
      for (size_t k = 0; k < goal.of.size(); ++k) differences_[k].weight = std::move(goal.of[k]);
      total_ = goal.total;
      return;
    }
    const Integer stay = (whole - step) * goal.total, go = step * total_;
    total_ *= goal.total * whole;
    Integer common = total_;
    for (size_t k = 0; k < goal.of.size(); ++k) {
      Integer& weight = differences_[k].weight;
      weight = weight * stay + goal.of[k] * go;
      common = gcd(common, weight);
    }
    std::erase_if(differences_,
                  [](const Difference& difference) { return difference.weight == 0; });
    for (Difference& difference : differences_) difference.weight /= common;
    total_ /= common;
  }
}

const NearestPoints::Found& NearestPoints::operator()(const Points<Rational>& from,
                                                      const Points<Rational>& to) {
  Integer scale = 1;
  for (const Points<Rational>* points : {&from, &to}) {
    for (const Vec3<Rational>& p : *points) add_denominators(p, scale);
  }
  std::array<Points<Integer>, 2> scaled;
  for (const Vec3<Rational>& p : from) scaled[0].push_back(scaled_by(scale, p));
  for (const Vec3<Rational>& p : to) scaled[1].push_back(scaled_by(scale, p));
  return (*this)(scaled, scale);
}

const NearestPoints::Found& NearestPoints::operator()(const std::array<Points<Integer>, 2>& points,
                                                      const Integer& scale) {
  if (found_.weights[0].size() != points[0].size() ||
      found_.weights[1].size() != points[1].size()) {
    differences_ = {{{0, 0}, {}, 1}};
    total_ = 1;
  }
  const auto way_between = [&](const std::array<size_t, 2>& places) -> Vec3<Integer> {
    return points[1][places[1]] - points[0][places[0]];
  };
  for (Difference& difference : differences_) difference.way = way_between(difference.places);
  Vec3<Integer> way;  // times the scale and total_
  Integer squared;
  for (;;) {
    settle();
    way = {0, 0, 0};
    for (const Difference& difference : differences_) way += difference.weight * difference.way;
    squared = dot(way, way);
    if (squared == 0) break;
    const std::array<size_t, 2> places = {support(points[0], way, -1), support(points[1], way, 1)};
    Vec3<Integer> least = way_between(places);
    if (total_ * dot(least, way) >= squared) break;
    differences_.push_back({places, std::move(least), 0});
  }
  const Integer whole = scale * total_;
  for (int k = 0; k < 3; ++k) found_.way[k] = fraction(way[k], whole);
  found_.squared = fraction(squared, Integer(whole * whole));
  for (size_t s = 0; s < 2; ++s) found_.weights[s].assign(points[s].size(), 0);
  for (const Difference& difference : differences_) {
    const Rational weight = fraction(difference.weight, total_);
    for (size_t s = 0; s < 2; ++s) found_.weights[s][difference.places[s]] += weight;
  }
  return found_;
}

}  // namespace ccdfuzz
