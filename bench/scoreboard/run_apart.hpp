#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

namespace ccdfuzz {

/// What a run of a driver gave.
struct DriverRun {
  std::uint64_t executions = 0;
  std::string found;  ///< what is wrong; empty if nothing was found
};

/// The same as the process reports it that it ran in.
struct Report {
  std::uint64_t reached = 0, triggered = 0, executions = 0;
  double seconds = 0;  ///< CPU
  bool detected = false;
  bool died = false;     ///< the process ended before the driver did: that is detected
  char found[512] = "";  ///< its first line, or as much of it as there is room for, and "…"

  /// Sets found.
  void tell(std::string_view text);
};

/// Ends its process by a signal if a step takes kHang CPU seconds, which no step does where the
/// sources are right. Beaten before each step.
class Heartbeat {
 public:
  static constexpr double kHang = 5;
  void beat();

 private:
  double last_ = -kHang;
};

/// Runs a driver with one fault active (or planted::kNone) in a process of its own, which ends when
/// the driver calls done. One that dies has noticed the fault. Errors: throws where the system
/// gives no process, and where the process was ended from outside (SIGKILL, SIGTERM, …): such a run
/// says nothing.
Report run_apart(
    int fault, double seconds,
    const std::function<void(const std::function<void(const DriverRun&)>& done)>& drive);

}  // namespace ccdfuzz
