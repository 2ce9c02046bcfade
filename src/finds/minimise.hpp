#pragma once

#include <cstdint>
#include <functional>

#include "case/case.hpp"

namespace ccdfuzz {

struct MinimiseOptions {
  std::uint64_t max_trials = 1000;  ///< how often to ask whether it still fails
  /// Asked before each trial: true ends it, with what there is.
  std::function<bool()> stop = [] { return false; };
};

struct Minimised {
  Case value;
  std::uint64_t trials = 0;
};

/// A simpler case that fails alike: fewer significant bits, exponents towards 0, fewer and equal
/// control points, no velocities, lower degrees and shapes.
/// still_fails: whether a case shows the very failure of `found`, whose outcome is `failure`. What
/// the outcome rests on holds of every case that it is asked about and of the result:
///   missed, late    a dyadic witness, at which the patches touch exactly, checked by
///   check_witness,
///                   inside of a patch, on its edge or at its corner as before, and not at t = 0
///                   unless it was
///   false_positive  nothing touches in [0, t_max] by certificate L; so it becomes a query of
///   linear
///                   patches, or comes back as it is
///   error           nothing; the result has no truth
/// A case whose truth is none of these comes back as it is. Never less simple than `found`.
/// Deterministic, but for stop.
Minimised minimise(const Case& found, Outcome failure,
                   const std::function<bool(const Case&)>& still_fails,
                   const MinimiseOptions& options = {});

}  // namespace ccdfuzz
