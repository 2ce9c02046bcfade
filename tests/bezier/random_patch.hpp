#pragma once

#include "bezier/patch.hpp"
#include "numeric/exact_scalars.hpp"
#include "rapidcheck.hpp"

namespace ccdfuzz {

inline rc::Gen<Shape> any_shape(int max_degree = 4) {
  return rc::gen::map(rc::gen::tuple(rc::gen::inRange(0, 4), rc::gen::inRange(1, max_degree + 1),
                                     rc::gen::inRange(1, max_degree + 1)),
                      [](const std::tuple<int, int, int>& t) {
                        const auto [kind, n, m] = t;
                        const std::array<Shape, 4> shapes = {Shape::point(), Shape::curve(n),
                                                             Shape::triangle(n),
                                                             Shape::tensor(n, m)};
                        return shapes.at(static_cast<size_t>(kind));
                      });
}

/// A multiple of 2^-6 in [-64, 64].
inline Dyadic any_coordinate() {
  return {Integer(*rc::gen::inRange(-4096, 4097)), -6};
}

inline Points<Dyadic> any_points(const Shape& shape) {
  Points<Dyadic> points;
  for (int i = 0; i < shape.control_count(); ++i) {
    points.push_back({any_coordinate(), any_coordinate(), any_coordinate()});
  }
  return points;
}

/// A dyadic point of the domain, in steps of 2^-4.
inline Uv<Dyadic> any_uv(const Shape& shape) {
  if (shape.kind == ShapeKind::kPoint) return {};
  const int u = *rc::gen::inRange(0, 17);
  if (shape.kind == ShapeKind::kCurve) return {Dyadic(u, -4), Dyadic()};
  const int v = *rc::gen::inRange(0, shape.kind == ShapeKind::kTriangle ? 17 - u : 17);
  return {Dyadic(u, -4), Dyadic(v, -4)};
}

}  // namespace ccdfuzz
