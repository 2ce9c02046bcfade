#include "certify/linear/origin_in_triangle.hpp"
#include "numeric/products.hpp"

#include <algorithm>

namespace ccdfuzz::linear {

OriginInTriangle::OriginInTriangle(const std::array<MovingVector, 3>& p) {
  std::array<MovingVector, 3> n;
  for (size_t i = 0; i < 3; ++i) n[i] = cross(p[(i + 1) % 3], p[(i + 2) % 3]);
  det_ = dot(p[0], n[0]);
  for (size_t i = 0; i < 3; ++i) {
    same_side_[i] = dot(n[(i + 1) % 3], n[(i + 2) % 3]);
    dots_[i] = dot(p[(i + 1) % 3], p[(i + 2) % 3]);
    spread_ += dot(n[i], n[i]);
  }
}

/// Given that the determinant is 0 at t.
bool OriginInTriangle::contains(RealRoot& t) const {
  for (const Polynomial& s : same_side_) {
    if (t.sign_of(s) < 0) return false;
  }
  if (t.sign_of(spread_) > 0) return true;
  return std::ranges::any_of(dots_, [&](const Polynomial& d) { return t.sign_of(d) <= 0; });
}

std::optional<RealRoot> OriginInTriangle::first(const Rational& until) const {
  const auto first_among = [&](const Polynomial& p) -> std::optional<RealRoot> {
    for (RealRoot& t : roots_in(p, 0, until)) {
      if (contains(t)) return t;
    }
    return std::nullopt;
  };
  if (!det_.is_zero()) return first_among(det_);
  if (RealRoot start(0); contains(start)) return start;
  std::optional<RealRoot> least;
  const auto consider = [&](const Polynomial& p) {
    if (p.is_zero()) return;
    std::optional<RealRoot> t = first_among(p);
    if (t && (!least || compare(*t, *least) < 0)) least = std::move(t);
  };
  for (const Polynomial& s : same_side_) consider(s);
  for (const Polynomial& d : dots_) consider(d);
  consider(spread_);
  return least;
}

std::array<Rational, 3> weights_of_origin(const std::array<Vec3<Rational>, 3>& corners) {
  std::array<Vec3<Rational>, 3> n;
  for (size_t i = 0; i < 3; ++i) n[i] = cross(corners[(i + 1) % 3], corners[(i + 2) % 3]);
  for (const Vec3<Rational>& plane : n) {
    if (dot(plane, plane) == 0) continue;
    std::array<Rational, 3> w;
    Rational sum = 0;
    for (size_t i = 0; i < 3; ++i) {
      w[i] = std::max(dot(n[i], plane), Rational(0));
      sum += w[i];
    }
    for (Rational& x : w) x /= sum;
    return w;
  }
  for (size_t i = 0; i < 3; ++i) {  // on a line: between corners a and b
    const size_t a = (i + 1) % 3, b = (i + 2) % 3;
    if (dot(corners[a], corners[b]) > 0) continue;
    std::array<Rational, 3> w = {0, 0, 0};
    w[a] = 1;
    for (int k = 0; k < 3; ++k) {
      if (corners[a][k] == 0) continue;
      w[a] = corners[b][k] / (corners[b][k] - corners[a][k]);
      w[b] = 1 - w[a];
      break;
    }
    return w;
  }
  return {1, 0, 0};
}

}  // namespace ccdfuzz::linear
