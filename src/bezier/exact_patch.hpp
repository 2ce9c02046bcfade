#pragma once

#include <array>
#include <optional>

#include "bezier/cell.hpp"
#include "bezier/patch.hpp"
#include "numeric/exact_scalars.hpp"

namespace ccdfuzz {

/// The same points in an exact number type.
template <class S>
Points<S> exact_points(const Points<double>& points) {
  Points<S> out;
  out.reserve(points.size());
  for (const Vec3<double>& p : points) {
    out.push_back({from_double<S>(p[0]), from_double<S>(p[1]), from_double<S>(p[2])});
  }
  return out;
}

/// The same patch in another number type, exactly, with velocities and its weights, without
/// its trim. S is Rational or Dyadic.
template <class S>
MovingPatch<S> exact_patch(const MovingPatch<double>& patch) {
  MovingPatch<S> out{patch.shape, exact_points<S>(patch.positions),
                     exact_points<S>(patch.velocities)};
  for (const double w : patch.weights) out.weights.push_back(from_double<S>(w));
  out.radius = from_double<S>(patch.radius);
  if (patch.has_ends()) {
    out.velocities = exact_points<S>(patch.ends);
    for (size_t i = 0; i < out.velocities.size(); ++i) out.velocities[i] -= out.positions[i];
  }
  return out;
}

template <class S>
std::array<Uv<S>, 3> exact_corners(const std::array<Uv<double>, 3>& corners) {
  std::array<Uv<S>, 3> out;
  for (size_t c = 0; c < 3; ++c) {
    out[c] = {from_double<S>(corners[c][0]), from_double<S>(corners[c][1])};
  }
  return out;
}

/// True iff (u, v) lies in the closed cell.
bool contains(const Cell& cell, const Shape& shape, const Uv<Rational>& uv);

/// The same points, of an exact type, as doubles. nullopt if some coordinate is not a double.
template <class Exact>
std::optional<Points<double>> to_doubles(const Points<Exact>& points) {
  Points<double> out;
  out.reserve(points.size());
  for (const Vec3<Exact>& p : points) {
    Vec3<double> q;
    for (int k = 0; k < 3; ++k) {
      const std::optional<double> d = p[k].to_double_exactly();
      if (!d) return std::nullopt;
      q[k] = *d;
    }
    out.push_back(q);
  }
  return out;
}

/// The same patch, of velocities and without weights, in doubles. nullopt if one is not a double.
template <class Exact>
std::optional<MovingPatch<double>> to_doubles(const MovingPatch<Exact>& patch) {
  const auto positions = to_doubles(patch.positions), velocities = to_doubles(patch.velocities);
  if (!positions || !velocities) return std::nullopt;
  return MovingPatch<double>{patch.shape, *positions, *velocities};
}

}  // namespace ccdfuzz
