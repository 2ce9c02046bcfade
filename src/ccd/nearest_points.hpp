#pragma once

#include <array>
#include <vector>

#include "bezier/patch.hpp"
#include "numeric/exact_scalars.hpp"

namespace ccdfuzz {

/// The nearest points of two convex hulls, exactly. Wolfe's algorithm finds the least vector of a
/// polytope, here of the hull of the differences of their points. Its candidates are the nearest
/// points of affinely independent differences. Each is nearer than the last, so it ends.
class NearestPoints {
 public:
  /// The way from a point of one hull to the nearest one of the other, and the weights that make
  /// both of the hulls' points.
  struct Found {
    Vec3<Rational> way;
    Rational squared;  ///< the length of the way
    std::array<std::vector<Rational>, 2> weights;
  };

  /// Requires a point of each. The next call begins where this one ended, if there are as many. It
  /// may be about hulls that were moved, and not about hulls that were turned.
  const Found& operator()(const Points<Rational>& from, const Points<Rational>& to);
  /// The same of points that are these over the scale, a number > 0.
  const Found& operator()(const std::array<Points<Integer>, 2>& points, const Integer& scale = 1);

  /// How fast the way last found changes where the second hull moves by a velocity. Its ends must
  /// stay on the same vertices, edges or faces. It is the difference of the velocity at right
  /// angles to these.
  Vec3<Rational> rate_of_way(const Vec3<Rational>& velocity) const;

 private:
  /// A difference to[places[1]] − from[places[0]], and its weight times total_.
  struct Difference {
    std::array<size_t, 2> places;
    Vec3<Integer> way;
    Integer weight;
  };
  /// Numbers times a total > 0.
  struct Shares {
    std::vector<Integer> of;
    Integer total;
  };

  void settle();
  Shares least_from(const Vec3<Integer>& base) const;

  // Integers with common denominators, as fractions would be reduced after each operation.
  std::vector<Difference> differences_;
  Integer total_;
  Found found_;
};

}  // namespace ccdfuzz
