#pragma once

#include <optional>

#include "case/query.hpp"
#include "numeric/rational.hpp"

namespace ccdfuzz {

/// How deep two bodies pass through each other in [0, until]: a lower bound; 0 where they do not
/// overlap. It is within a few ulps, unless a body spins or turns by an angle: then it may be lower
/// by 2^-90 of the centre's largest coordinate. The depth is the least distance by which one of
/// them, moved whatever way, would touch the other nowhere in that time. A miss overlooks that much
/// until t_max, a late hit until its time. Nothing where the hulls themselves overlap and have more
/// pairs of points than kMostPairs. Where a body turns, it is the deepest overlap at nine times.
/// For a mesh it is that of its deepest face. in_plane: ways are in the plane z = 0, in which the
/// bodies then are. Requires a valid query of bodies and a finite until ≥ 0.
std::optional<double> depth_until(const Query& query, double until, bool in_plane = false);

/// An upper bound of how fast a point of one body moves against those of the other. It is little
/// more than the least one where no body turns from one rotation to another. Requires what
/// depth_until does.
Rational greatest_speed(const Query& query);

/// Hulls with more pairs of points than this would take seconds.
inline constexpr size_t kMostPairs = 144;

}  // namespace ccdfuzz
