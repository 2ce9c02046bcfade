#include "ccd/witness_trace/loss_signature.hpp"

#include <fmt/format.h>

namespace ccdfuzz {

std::string loss_cause(const Trace& trace) {
  if (!trace.loss) return "";
  const ExcludedInterval& by = trace.loss->by;
  if (by.axis < 0) return "hull";
  if (by.times.has_lo) return by.times.has_hi ? "whole window" : "right root";
  return by.times.has_hi ? "left root" : "both roots";
}

std::string loss_signature(const Trace& trace) {
  if (!trace.loss) return "";
  const ExcludedInterval& by = trace.loss->by;
  const int level = trace.loss->place.level;
  if (by.axis < 0) return fmt::format("level {}, hull", level);
  // Axes of oriented boxes: those of patch 1, those of patch 2, and their cross products.
  const char* axes = by.axis < 3 ? "1-3" : by.axis < 6 ? "4-6" : "7-";
  return fmt::format("level {}, axes {}, {}", level, axes, loss_cause(trace));
}

}  // namespace ccdfuzz
