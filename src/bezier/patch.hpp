#pragma once

#include <algorithm>
#include <array>
#include <cstring>
#include <optional>
#include <type_traits>
#include <vector>

#include "base/double_parts.hpp"
#include "bezier/shape.hpp"
#include "bezier/turn.hpp"
#include "numeric/vec3.hpp"

namespace ccdfuzz {

/// Parameters of a point of a patch; those that the shape does not have are 0.
template <class S>
using Uv = std::array<S, 2>;

template <class S>
using Points = std::vector<Vec3<S>>;

/// All numbers are equal. Doubles are if their bits are; weights are > 0, so that no more would be.
template <class S>
bool are_equal(const std::vector<S>& numbers) {
  if (numbers.size() < 2) return true;
  if constexpr (std::is_same_v<S, double>) {  // each has the bits of the next
    return std::memcmp(&numbers[0], &numbers[1], (numbers.size() - 1) * sizeof(double)) == 0;
  } else {
    return std::equal(numbers.begin() + 1, numbers.end(), numbers.begin());
  }
}

/// Closed polygons in a patch's domain, the last vertex joined to the first.
using Trim = std::vector<std::vector<Uv<double>>>;

/// A triangle of a mesh: the places of its corners among the points. Seen from its front they are
/// counter-clockwise.
using Face = std::array<int, 3>;

/// A Bézier patch whose control points move linearly (Eq. 2). At time t control point i stands at
/// positions[i] + t·velocities[i]; or, where `ends` are given, at
/// positions[i] + t·(ends[i] − positions[i]), with a difference that need be no double.
/// Each array has shape.control_count() entries, in Shape's order; of velocities and ends one has,
/// and the other is empty. With `weights` w the patch is rational: its point is the sum of
/// w·B·control point over the sum of w·B, B the Bernstein weights. They do not move.
/// Loops in `trim` restrict the patch to their closed even-odd region (trim_region.hpp). A
/// parameter is in it if it lies on a loop, or if an odd number of loops go around it. Only
/// triangles and tensors are trimmed. A hull is a body: all that is within `radius` of the convex
/// hull of its points. It has one velocity for all of its points, no ends and no weights. It may
/// turn, too. With faces it is a mesh (case/mesh.hpp). Other patches have the radius 0, do not turn
/// and have no faces.
template <class S>
struct MovingPatch {
  Shape shape;
  Points<S> positions;
  Points<S> velocities;
  Points<S> ends = {};          ///< positions at t = 1
  std::vector<S> weights = {};  ///< > 0; empty: polynomial
  S radius = S(0);
  Trim trim = {};  ///< empty: all of the shape's domain
  std::optional<BodyTurn> turn = {};
  std::vector<Face> faces = {};  ///< empty: the body is its points' hull
  bool one_sided = false;        ///< a mesh that has fronts alone

  bool has_ends() const { return !ends.empty(); }
  /// The ends or, without them, the velocities.
  Points<S>& moves() { return has_ends() ? ends : velocities; }
  const Points<S>& moves() const { return has_ends() ? ends : velocities; }
  /// Equal weights, and those of points, are the polynomial patch.
  bool is_rational() const { return !are_equal(weights); }

  /// The velocity of control point i. Requires velocities.
  const Vec3<S>& velocity(size_t i) const {
    return velocities[shape.kind == ShapeKind::kHull ? 0 : i];
  }

  /// The control points at time t. Requires velocities, and no turn.
  Points<S> at(const S& t) const {
    Points<S> p(positions.size());
    for (size_t i = 0; i < p.size(); ++i) {
      for (int k = 0; k < 3; ++k) p[i][k] = S(positions[i][k] + S(t * velocity(i)[k]));
    }
    return p;
  }

  friend bool operator==(const MovingPatch&, const MovingPatch&) = default;
};

}  // namespace ccdfuzz
