#pragma once

#include <limits>
#include <utility>

#include "base/stopwatch.hpp"

namespace ccdfuzz {

/// Thrown where the time of a TimeLimit is over.
struct OutOfTime {};

/// While it lives, long exact arithmetic on this thread throws OutOfTime soon after its time is
/// over: it calls stop_if_late between steps. Another that is made meanwhile holds in its place.
class TimeLimit {
 public:
  static constexpr double kNone = std::numeric_limits<double>::max();

  /// seconds: from now on; kNone or more: no limit. clock: in seconds; null: steady_seconds.
  TimeLimit(double seconds, double (*clock)()) : clock_(clock != nullptr ? clock : steady_seconds) {
    if (seconds < kNone) end_ = clock_() + seconds;
  }
  ~TimeLimit() { here() = before_; }
  TimeLimit(const TimeLimit&) = delete;
  TimeLimit& operator=(const TimeLimit&) = delete;

  static void stop_if_late() {
    const TimeLimit* const limit = here();
    if (limit != nullptr && limit->end_ < kNone && limit->clock_() > limit->end_) throw OutOfTime{};
  }

 private:
  static const TimeLimit*& here() {
    thread_local const TimeLimit* limit = nullptr;
    return limit;
  }

  double (*clock_)();
  double end_ = kNone;
  const TimeLimit* before_ = std::exchange(here(), this);
};

}  // namespace ccdfuzz
