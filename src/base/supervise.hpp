#pragma once

namespace ccdfuzz {

/// Parts the process in three: two that watch, one below the other, and the child of the lower one,
/// in which this returns and which goes on as it is, in a process group that it shares with its
/// parent. Who watches waits for what is below to end, then ends all that it has started and that
/// lives on, in whatever session and process group, and ends as it did: by the same signal or with
/// the same code. On SIGTERM, or when whoever is above is gone, all of them end at once. So the
/// child may kill its parent or its process group, and still nothing lives on; only what kills both
/// that watch, of which the upper one is neither its parent nor of its group, gets away.
void continue_in_supervised_child();

}  // namespace ccdfuzz
