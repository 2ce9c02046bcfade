#pragma once

#include <optional>

#include "bezier/patch.hpp"

namespace ccdfuzz {

/// The same points, of an exact type, as doubles. nullopt if a coordinate is none.
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

}  // namespace ccdfuzz
