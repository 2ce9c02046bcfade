#pragma once

#include <functional>

#include "planted.hpp"
#include "run_apart.hpp"

namespace ccdfuzz {

/// What the right sources met on the course that a driver takes with them.
struct WatchReport {
  Report report;  ///< detected: the driver calls right sources wrong
  planted::Watched faults;
};

/// Runs a driver on the right sources, all faults watched, in a process of its own. A wrong value
/// that cannot be computed without the process's end counts as triggered, and the run begins anew.
WatchReport watch_apart(
    double seconds,
    const std::function<void(const std::function<void(const DriverRun&)>& done)>& drive);

}  // namespace ccdfuzz
