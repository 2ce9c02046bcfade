#pragma once

#include "certify/oracle/oracle.hpp"

namespace ccdfuzz {

/// decide for a valid query of bodies, by exact nearest points (NearestPoints); no search, and no
/// limit of time is needed.
/// A miss is one direction for all of [0, t_max]: along the way from patch 1 to patch 2 where that
/// is swept along its relative velocity.
/// Else Newton's method: at t the way w from patch 1 to the nearest point of patch 2, as a
/// direction, keeps them apart until t' = t + (|w|² − reach·|w|) / −w·v. Their distance is convex
/// in t, so t' nears the first contact from below, quadratically, and is the first contact where
/// only touching is asked. Else w changes linearly while the nearest features stay the same, and a
/// rational time at which it is as long as the reach is tried. So the witness is at clear_until
/// where that time is rational. Where it is not, or the bodies graze, it comes at most 2^-40 of it
/// later.
///
/// For a mesh it is the least over the faces that are there, and certificate F.
Decision decide_bodies(const Query& query, const OracleOptions& options);

}  // namespace ccdfuzz
