#pragma once

#include <algorithm>
#include <cmath>

#include "base/nearest_float.hpp"
#include "case/query.hpp"

namespace ccdfuzz {

/// The largest magnitude of a coordinate; 0 of no points.
inline double largest_coordinate(const Points<double>& points) {
  double largest = 0;
  for (const Vec3<double>& p : points) largest = std::max(largest, p.cwiseAbs().maxCoeff());
  return largest;
}

/// The same of the positions of both patches.
inline double largest_coordinate(const Query& query) {
  return std::max(largest_coordinate(query.patches[0].positions),
                  largest_coordinate(query.patches[1].positions));
}

/// The same at 0 and at t_max; ignores turns.
inline double largest_coordinate_at_ends(const Query& query) {
  double largest = largest_coordinate(query);
  for (const MovingPatch<double>& patch : query.patches) {
    for (size_t i = 0; i < patch.positions.size(); ++i) {
      const Vec3<double> moved = patch.positions[i] + query.t_max * rounded_velocity(patch, i);
      largest = std::max(largest, moved.cwiseAbs().maxCoeff());
    }
  }
  return largest;
}

/// True iff good(x) for each number x of a query.
template <class Good>
bool are_all(const Query& query, const Good& good) {
  bool all = true;
  for_each_number(query, [&](double x) { all = all && good(x); });
  return all;
}

/// True iff every number of a query is 0 or of a magnitude in [2^-bits, 2^bits]. Where bits are
/// few, neither under- nor overflow explains a failure.
inline bool is_within_scale(const Query& query, int bits) {
  const double least = std::ldexp(1.0, -bits), most = std::ldexp(1.0, bits);
  return are_all(query,
                 [&](double x) { return x == 0 || (std::abs(x) >= least && std::abs(x) <= most); });
}

/// True iff each number of the query is a finite float (binary32), as engines have them.
inline bool is_binary32(const Query& query) {
  return are_all(query, is_float);
}

/// True iff two bodies lie and move in the plane z = 0, as those of 2-D engines do.
inline bool is_in_plane(const Query& query) {
  bool all_are = is_of_bodies(query);
  const auto check = [&](const Vec3<double>& v) { all_are = all_are && v[2] == 0; };
  for (const MovingPatch<double>& patch : query.patches) {
    std::ranges::for_each(patch.positions, check);
    std::ranges::for_each(patch.velocities, check);
    if (!patch.turn) continue;
    check(patch.turn->centre);
    for (const auto* q : {&patch.turn->from, &patch.turn->to}) {
      if (q->size() == 4) all_are = all_are && (*q)[1] == 0 && (*q)[2] == 0;
    }
    if (const auto& w = patch.turn->spin; !w.empty()) all_are = all_are && w[0] == 0 && w[1] == 0;
  }
  return all_are;
}

}  // namespace ccdfuzz
