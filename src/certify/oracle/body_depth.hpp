#pragma once

#include <algorithm>
#include <optional>

#include "case/query.hpp"
#include "numeric/rational.hpp"

namespace ccdfuzz {

/// How deep two bodies pass through each other in [0, until]: a lower bound; 0 where they do not
/// overlap. It is within a few ulps, unless a body spins or turns by an angle: then it may be lower
/// by 2^-90 of the centre's largest coordinate. The depth is the least distance by which one of
/// them, moved whatever way, would touch the other nowhere in that time. A miss overlooks that much
/// until t_max, a late hit until its time. Nothing where the hulls themselves overlap and have many
/// points (is_measured). Where a body turns, it is the deepest overlap at one time, and may be
/// lower by a part. For a mesh it is that of its deepest face. in_plane: ways are in the
/// plane z = 0, in which the bodies then are. Requires a valid query of bodies and a finite until
/// ≥ 0.
std::optional<double> depth_until(const Query& query, double until, bool in_plane = false);

/// Whether that depth is more than `most` ≥ 0. Nothing where it is not measured, or where a body
/// turns and at no time that was looked at the overlap is deeper.
std::optional<bool> is_deeper_until(const Query& query, double until, const Rational& most,
                                    bool in_plane);

/// An upper bound of how fast a point of one body moves against those of the other. It is little
/// more than the least one where no body turns from one rotation to another. Requires what
/// depth_until does.
Rational greatest_speed(const Query& query);

/// Whether hulls of so many points are measured where they overlap: others would take seconds. The
/// time grows as the points times the fourth power of how many one hull has.
constexpr bool is_measured(size_t first, size_t second) {
  constexpr size_t kPairsMeasured = 144, kPointsMeasured = 24;
  return first * second <= kPairsMeasured && std::max(first, second) <= kPointsMeasured;
}

}  // namespace ccdfuzz
