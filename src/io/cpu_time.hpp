#pragma once

#include <ctime>

#include "base/verify.hpp"

namespace ccdfuzz {

/// CPU time that the calling thread has used, in seconds.
inline double thread_cpu_seconds() {
  timespec now{};
  CCDFUZZ_VERIFY(clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now) == 0);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace ccdfuzz
