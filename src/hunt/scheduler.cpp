#include "hunt/scheduler.hpp"

#include <algorithm>

#include "base/verify.hpp"

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

}  // namespace ccdfuzz
