#include "hunt/scheduler.hpp"

#include <algorithm>
#include <ctime>

#include "numeric/verify.hpp"

namespace ccdfuzz {

size_t Scheduler::begin() {
  CCDFUZZ_VERIFY(!cells_.empty());
  const auto expected = [](const Cell& c) {
    return c.used + c.last * static_cast<double>(c.running);
  };
  const auto next = std::ranges::min_element(cells_, [&](const Cell& a, const Cell& b) {
    // The cost of a first turn is unknown, and a coarse clock may see none at all.
    return expected(a) != expected(b) ? expected(a) < expected(b) : a.begun < b.begun;
  });
  ++next->running;
  ++next->begun;
  return static_cast<size_t>(next - cells_.begin());
}

void Scheduler::end(size_t cell, double seconds) {
  Cell& c = cells_[cell];
  CCDFUZZ_VERIFY(c.running > 0 && seconds >= 0);
  --c.running;
  c.used += seconds;
  c.last = seconds;
}

double thread_cpu_seconds() {
  timespec now{};
  CCDFUZZ_VERIFY(clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now) == 0);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace ccdfuzz
