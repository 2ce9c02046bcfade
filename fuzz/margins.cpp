#include "fuzz/margins.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace {

constexpr std::size_t kPerDoubling = 8;
/// Margins and slacks from 2^-64 to 2^64 of their unit.
constexpr std::size_t kDoublings = 128;
constexpr std::size_t kPerMethod = kPerDoubling * kDoublings;

}  // namespace

// libFuzzer reads this section. Static, or unread by anybody, it would be left out.
extern "C" {
__attribute__((section("__libfuzzer_extra_counters"))) volatile std::uint8_t
    ccdfuzz_margin_counters[ccdfuzz::Margins::kMethods * kPerMethod];
}

namespace ccdfuzz {

void Margins::note(std::size_t method, const Trace& trace) {
  if (!trace.slack && !trace.margin && !trace.lost) return;
  double distance = 0;
  if (trace.slack) {
    distance = std::max(trace.slack->value, 0.0);
  } else if (trace.margin) {
    distance = static_cast<double>(trace.margin->ulps);
  }
  if (trace.lost) distance = 0;
  // −64 for 0 and all that is as good as 0.
  const double doublings = std::clamp(std::log2(distance), -64.0, 63.99);
  const auto nearness = static_cast<std::size_t>((64 - doublings) * kPerDoubling);
  for (std::size_t i = 0; i < std::min(nearness, kPerMethod); ++i) {
    ccdfuzz_margin_counters[method * kPerMethod + i] = 1;
  }
}

}  // namespace ccdfuzz
