#include "watch_apart.hpp"

#include <sys/mman.h>

#include <stdexcept>

namespace ccdfuzz {

WatchReport watch_apart(
    double seconds,
    const std::function<void(const std::function<void(const DriverRun&)>& done)>& drive) {
  using planted::Watched;
  void* const shared =
      mmap(nullptr, sizeof(Watched), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (shared == MAP_FAILED) throw std::runtime_error("no shared memory");
  planted::watched = new (shared) Watched;
  WatchReport out;
  for (bool again = true; again;) {
    planted::watched->asked = planted::kNone;
    out.report = run_apart(planted::kWatchAll, seconds, drive);
    const int asked = planted::watched->asked;
    again = out.report.died && asked != planted::kNone && !planted::watched->triggered[asked];
    if (again) planted::watched->triggered[asked] = true;
  }
  out.faults = *planted::watched;
  planted::watched = nullptr;
  munmap(shared, sizeof(Watched));
  return out;
}

}  // namespace ccdfuzz
