#pragma once

#include <cstdint>
#include <functional>

#include "finds/failure.hpp"

namespace ccdfuzz {

struct MinimiseOptions {
  /// How often to ask whether it still fails; most finds need fewer to come to an end.
  std::uint64_t max_trials = 1000;
  /// Asked before each trial: true ends it, with what there is.
  std::function<bool()> stop = [] { return false; };
  /// Simpler cases of which this is false are not asked about, if it is true of the first.
  std::function<bool(const Case&)> admits = [](const Case&) { return true; };
};

struct Minimised {
  Case value;
  std::uint64_t trials = 0;
};

/// A simpler case that fails alike: fewer significant bits, exponents towards 0, fewer and equal
/// control points, no velocities, lower degrees and shapes.
/// still_fails: whether a case shows the very failure of `found`, whose outcome is `failure`. It is
/// asked only about cases, and the result is one, of which this holds:
///   missed, late    a dyadic witness, at which check_witness finds the patches in contact. It is
///                   inside of a patch, on its edge or at its corner as before, and not at t = 0
///                   unless it was. Without one, linear patches that are decided to touch, inside
///                   or where the witness of `found` is; they may lose their separation. Or others
///                   that the oracle proves to touch, where `found` has a contact box. There the
///                   parameters that it names are inside, on an edge or at a corner as before, and
///                   clear_until is above 0 if it was
///   false_positive  nothing touches in [0, t_max], by certificate L of linear patches, else by a
///                   plane (certificate P), which `found` must have then
///   error           nothing; the result has no truth
/// The truth of bodies is decided exactly each time (case_of_bodies); the class of the contact that
/// this says stays. A query whose numbers are all floats stays one. A t_max above 0 stays above 0.
/// A case of which that cannot be made to hold comes back as it is. Never less simple than `found`.
/// Deterministic, except for stop.
Minimised minimise(const Case& found, Outcome failure,
                   const std::function<bool(const Case&)>& still_fails,
                   const MinimiseOptions& options = {});

/// The same of a case that shows a failure of a method, by what the method says of simpler ones.
/// One whose patches pass through each other stays at least half as deep as the deepest form that
/// was taken, relative to its size.
/// The result expects this failure alone, and has no name. For a hang only a few trials are
/// made, since each costs all of its time.
Minimised minimise(const Case& found, const Failure& failure, Asker& asker,
                   MinimiseOptions options = {});

}  // namespace ccdfuzz
