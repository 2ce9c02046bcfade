#pragma once

#include <string>

#include "ccd/witness_trace/trace.hpp"

namespace ccdfuzz {

/// What lost a witness: what is wrong with the claim of the axis that claims t*,
///   "whole window"  it separates the window's start and end (Eq. 7 at both)
///   "right root"    it separates the start, and the time until when comes out too late
///   "left root"     it separates the end, and the time from when comes out too early
///   "both roots"    it separates something in between
///   "hull"          no axis claims t*, which is lost all the same
/// Empty if it was not lost.
std::string loss_cause(const Trace& trace);

/// The same, more finely: before the cause it says the level of the cells, and among which axes the
/// one is that claims t*.
std::string loss_signature(const Trace& trace);

}  // namespace ccdfuzz
