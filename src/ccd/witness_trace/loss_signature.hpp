#pragma once

#include <string>

#include "ccd/witness_trace/trace.hpp"

namespace ccdfuzz {

/// How a witness was lost, in few words by which like losses are told from others: the level of the
/// cells; among which axes the one is that claims t*; and what of its claim is wrong,
///   "whole window"  it separates the window's start and end (Eq. 7 at both)
///   "right root"    it separates the start, and the time until when comes out too late
///   "left root"     it separates the end, and the time from when comes out too early
///   "both roots"    it separates something in between
///   "hull"          no axis claims t*, which is lost all the same
/// Empty if it was not lost.
std::string loss_signature(const Trace& trace);

}  // namespace ccdfuzz
