#pragma once

#include <array>
#include <vector>

#include "bezier/shape.hpp"
#include "numeric/vec3.hpp"

namespace ccdfuzz {

/// Parameters of a point of a patch; those that the shape does not have are 0.
template <class S>
using Uv = std::array<S, 2>;

template <class S>
using Points = std::vector<Vec3<S>>;

/// A Bézier patch whose control points move linearly (Eq. 2): at time t control point i stands at
/// positions[i] + t·velocities[i]. Both arrays have shape.control_count() entries, in Shape's
/// order.
template <class S>
struct MovingPatch {
  Shape shape;
  Points<S> positions;
  Points<S> velocities;

  /// The control points at time t.
  Points<S> at(const S& t) const {
    Points<S> p(positions.size());
    for (size_t i = 0; i < p.size(); ++i) {
      for (int k = 0; k < 3; ++k) p[i][k] = S(positions[i][k] + S(t * velocities[i][k]));
    }
    return p;
  }

  friend bool operator==(const MovingPatch&, const MovingPatch&) = default;
};

}  // namespace ccdfuzz
