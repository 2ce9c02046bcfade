#include "fuzz/margins.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>

namespace ccdfuzz {

namespace {

constexpr double kLeast = -64, kDoublingsEach = 4;

struct Nearness {
  double distance;
  const TracePlace* place;
  bool later;  ///< by an exclusion that begins later than the window
};

std::optional<Nearness> nearness_of(const Trace& trace) {
  if (trace.lost && trace.loss) return Nearness{0, &trace.loss->place, false};
  if (trace.slack) return Nearness{std::max(trace.slack->value, 0.0), &trace.slack->place, false};
  if (!trace.margin) return std::nullopt;
  const TracePlace& place = trace.margin->place;
  return Nearness{static_cast<double>(trace.margin->ulps), &place,
                  trace.margin->by.times.lo > place.window.lo};
}

}  // namespace

}  // namespace ccdfuzz

// libFuzzer reads this section. Static, or unread by anybody, it would be left out.
extern "C" {
__attribute__((section("__libfuzzer_extra_counters"))) volatile std::uint8_t
    ccdfuzz_margin_counters[ccdfuzz::Margins::kCounters];
}

namespace ccdfuzz {

void Margins::note(std::size_t method, const Trace& trace) {
  static const bool is_off = std::getenv("CCDFUZZ_WITHOUT_MARGINS") != nullptr;
  const std::optional<Nearness> near = is_off ? std::nullopt : nearness_of(trace);
  if (!near) return;
  // The least for 0 and all that is as good as 0, and for what is no number.
  const double doublings =
      near->distance > 0 ? std::clamp(std::log2(near->distance), kLeast, -kLeast - 1) : kLeast;
  const auto bucket = static_cast<std::size_t>((doublings - kLeast) / kDoublingsEach);
  const auto level = std::min(static_cast<std::size_t>(near->place->level), kLevels - 1);
  const std::size_t place = ((method * kLevels + level) * 2 + (near->later ? 1 : 0)) * kBuckets;
  ccdfuzz_margin_counters[place + bucket] = 1;
}

}  // namespace ccdfuzz
