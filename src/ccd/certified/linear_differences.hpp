#pragma once

#include <algorithm>
#include <array>

#include "ccd/certified/normalise.hpp"
#include "ccd/certified/pair_axes.hpp"

namespace ccdfuzz::certified {

/// The differences of all pairs of control points, D + t·W: the patches touch iff the origin is in
/// their convex hull. Four for edges, where a point is an edge of no extent; three for a face.
/// Laws C and L9 count the roundings of D, W and D + t·W.
struct Differences {
  std::array<Axis, 4> start{}, way{};
  int count = 0;
  bool is_face = false;
  int face_side = 0;

  explicit Differences(const NormalisedQuery& query) {
    const auto corner = [&](int side, int i) -> const std::array<double, 6>& {
      const auto& controls = query.controls[static_cast<size_t>(side)];
      return controls[std::min(static_cast<size_t>(i), controls.size() - 1)];
    };
    for (int s = 0; s < 2; ++s) {
      if (query.shapes[static_cast<size_t>(s)].kind == ShapeKind::kTriangle) {
        is_face = true;
        face_side = s;
      }
    }
    const auto add = [&](const std::array<double, 6>& p, const std::array<double, 6>& q) {
      const auto n = static_cast<size_t>(count++);
      for (size_t k = 0; k < 3; ++k) {
        start[n][k] = p[k] - q[k];
        way[n][k] = p[k + 3] - q[k + 3];
      }
    };
    if (is_face) {
      for (int i = 0; i < 3; ++i) add(corner(face_side, i), corner(1 - face_side, 0));
    } else {  // p0 − q0, p1 − q0, p0 − q1, p1 − q1
      for (int j = 0; j < 2; ++j) {
        for (int i = 0; i < 2; ++i) add(corner(0, i), corner(1, j));
      }
    }
  }

  Axis at(int i, double t) const {
    const auto n = static_cast<size_t>(i);
    return {start[n][0] + t * way[n][0], start[n][1] + t * way[n][1], start[n][2] + t * way[n][2]};
  }
};

}  // namespace ccdfuzz::certified
