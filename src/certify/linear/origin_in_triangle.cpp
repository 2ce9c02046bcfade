#include "certify/linear/origin_in_triangle.hpp"

#include <algorithm>

#include "numeric/products.hpp"

namespace ccdfuzz::linear {

namespace {

/// Makes `least` the first root of p in the closed [0, until] at which it holds, if that is less.
template <class Holds>
void take_first(const Polynomial& p, const Rational& until, const Holds& holds,
                std::optional<RealRoot>& least) {
  if (p.is_zero()) return;
  for (RealRoot& t : roots_in(p, 0, until)) {
    if (!holds(t)) continue;
    if (!least || compare(t, *least) < 0) least = std::move(t);
    return;
  }
}

/// The point nearest to the origin on a corner of a triangle, on the line of an edge or on the
/// plane: Σ weights·corners / sum. It is of the corner, edge or triangle iff the weights are ≥ 0
/// and the sum is > 0. The sum is 0 where there is no such line or plane. The square of the
/// distance is square / sum.
struct Foot {
  std::array<Polynomial, 3> weights;
  Polynomial sum, square;
};

constexpr size_t kFeatures = 7;

/// With n_i the cross product of the other two corners, N the sum of the n_i:
/// - a corner a: weight 1, square a·a;
/// - the line of a, b: weights b·b − a·b and a·a − a·b, with the sum |b − a|², square |a×b|²;
/// - the plane: weights n_i·N, with the sum N·N, square (a·n_a)².
Foot foot_of_origin(const std::array<MovingVector, 3>& p, size_t feature) {
  const size_t i = feature % 3, j = (i + 1) % 3;
  Foot out;
  if (feature < 3) {
    out.weights[i] = Polynomial({1});
    out.square = dot(p[i], p[i]);
  } else if (feature < 6) {
    const Polynomial along = dot(p[i], p[j]);
    const MovingVector n = cross(p[i], p[j]);
    out.weights[i] = dot(p[j], p[j]) - along;
    out.weights[j] = dot(p[i], p[i]) - along;
    out.square = dot(n, n);
  } else {
    std::array<MovingVector, 3> n;
    for (size_t c = 0; c < 3; ++c) n[c] = cross(p[(c + 1) % 3], p[(c + 2) % 3]);
    for (size_t c = 0; c < 3; ++c) {
      for (const MovingVector& other : n) out.weights[c] += dot(n[c], other);
    }
    const Polynomial volume = dot(p[0], n[0]);
    out.square = volume * volume;
  }
  for (const Polynomial& w : out.weights) out.sum += w;
  return out;
}

}  // namespace

std::optional<RealRoot> first_at_origin(const std::array<MovingVector, 3>& p,
                                        const Rational& until) {
  std::array<MovingVector, 3> n;
  for (size_t i = 0; i < 3; ++i) n[i] = cross(p[(i + 1) % 3], p[(i + 2) % 3]);
  const Polynomial det = dot(p[0], n[0]);
  std::array<Polynomial, 3> same_side, dots;
  Polynomial spread;
  for (size_t i = 0; i < 3; ++i) {
    same_side[i] = dot(n[(i + 1) % 3], n[(i + 2) % 3]);
    dots[i] = dot(p[(i + 1) % 3], p[(i + 2) % 3]);
    spread += dot(n[i], n[i]);
  }
  // Given that the determinant is 0 at t.
  const auto contains = [&](RealRoot& t) {
    return std::ranges::none_of(same_side, [&t](const auto& s) { return t.sign_of(s) < 0; }) &&
           (t.sign_of(spread) > 0 ||
            std::ranges::any_of(dots, [&t](const auto& d) { return t.sign_of(d) <= 0; }));
  };
  std::optional<RealRoot> least;
  take_first(det, until, contains, least);
  if (!det.is_zero()) return least;
  if (RealRoot start(0); contains(start)) return start;
  for (const Polynomial& s : same_side) take_first(s, until, contains, least);
  for (const Polynomial& d : dots) take_first(d, until, contains, least);
  take_first(spread, until, contains, least);
  return least;
}

std::optional<RealRoot> first_near(const std::array<MovingVector, 3>& p, const Integer& distance,
                                   const Rational& until) {
  const Polynomial squared({Integer(distance * distance)});
  std::optional<RealRoot> least;
  for (size_t feature = 0; feature < kFeatures; ++feature) {
    const Foot foot = foot_of_origin(p, feature);
    const auto is_in_triangle = [&foot](RealRoot& t) {
      return t.sign_of(foot.sum) > 0 &&
             std::ranges::none_of(foot.weights, [&t](const auto& w) { return t.sign_of(w) < 0; });
    };
    const Polynomial excess = foot.square - squared * foot.sum;
    if (RealRoot start(0); start.sign_of(excess) <= 0 && is_in_triangle(start)) return start;
    take_first(excess, least ? least->hi() : until, is_in_triangle, least);
  }
  return least;
}

}  // namespace ccdfuzz::linear
