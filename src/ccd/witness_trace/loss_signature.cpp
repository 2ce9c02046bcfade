#include "ccd/witness_trace/loss_signature.hpp"

#include <fmt/format.h>

namespace ccdfuzz {

std::string loss_signature(const Trace& trace) {
  if (!trace.loss) return "";
  const Exclusion& by = trace.loss->by;
  const int level = trace.loss->place.level;
  if (by.axis < 0) return fmt::format("level {}, hull", level);
  // Of oriented boxes: those of patch 1, those of patch 2, and their cross products.
  const char* axes = by.axis < 3 ? "1-3" : by.axis < 6 ? "4-6" : "7-";
  const char* quantity = by.times.has_lo   ? by.times.has_hi ? "whole window" : "right root"
                         : by.times.has_hi ? "left root"
                                           : "both roots";
  return fmt::format("level {}, axes {}, {}", level, axes, quantity);
}

}  // namespace ccdfuzz
