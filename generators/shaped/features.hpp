#pragma once

#include <optional>
#include <vector>

#include "bezier/patch.hpp"
#include "generators/draw/draw.hpp"
#include "generators/prescribe.hpp"
#include "numeric/exact_scalars.hpp"

namespace ccdfuzz {

/// An edge of a patch, or a curve as a whole: its points are origin + s·direction for s in [0, 1].
struct ShapeEdge {
  std::array<int, 2> origin;
  std::array<int, 2> direction;

  Uv<Dyadic> at(const Dyadic& s) const;
  int degree(const Shape& shape) const { return direction[0] != 0 ? shape.n : degree_in_v(shape); }
  /// The s of a point of the edge; nullopt if it lies on none.
  std::optional<Dyadic> parameter_of(const Uv<Dyadic>& uv) const;
  /// Places of the edge's control points, by rising s.
  std::vector<size_t> controls(const Shape& shape) const;

 private:
  static int degree_in_v(const Shape& shape) {
    return shape.kind == ShapeKind::kTriangle ? shape.n : shape.m;
  }
};

std::vector<ShapeEdge> edges_of(const Shape& shape);
/// Those that the point lies on.
std::vector<ShapeEdge> edges_through(const Shape& shape, const Uv<Dyadic>& uv);
std::vector<Uv<Dyadic>> corners_of(const Shape& shape);

/// Faces are what triangles and tensor patches have; a curve is an edge between its two corners,
/// and a point a corner.
bool has_feature(const Shape& shape, Feature feature);

/// The feature that a point of a shape lies on.
Feature feature_at(const Shape& shape, const Uv<Dyadic>& uv);
/// The same of a quadratic triangle.
inline Feature feature_at(const Barycentric& x) {
  return feature_at(kQuadratic, {x[0], x[1]});
}

/// True iff the control point at this place has a share in the point: its weight there is not 0.
bool bears(const Shape& shape, const Uv<Dyadic>& uv, int i, int j);

/// The parameters of a patch that those of a part of it mean. The part has its (u, v) = (0, 0),
/// (1, 0) and (0, 1) at the corners, or if it is no triangle (0, 0) and (1, 1) at the first two.
Uv<Dyadic> on_whole(const Shape& shape, const std::array<Uv<Dyadic>, 3>& part,
                    const Uv<Dyadic>& uv);

/// A shape that has the feature: triangles of degree 1 to 5, tensor patches of degrees 1 to 4,
/// sometimes a curve or a point.
Shape random_shape(Feature feature, Draw& draw);

/// A random point on the feature: multiples of 2^-bits, bits ≥ 2.
Uv<Dyadic> point_on(Feature feature, const Shape& shape, int bits, Draw& draw);

/// As many bits as parameters may have so that Bernstein weights have 24 or fewer, and at most 12.
int parameter_bits(const Shape& shape);

}  // namespace ccdfuzz
