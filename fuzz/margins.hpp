#pragma once

#include <cstddef>

#include "ccd/witness_trace/trace.hpp"

namespace ccdfuzz {

/// Tells libFuzzer how nearly a method lost a contact, as coverage of a kind of its own. There is a
/// counter for each method, level, end of the window that is at stake, and four doublings of the
/// distance. So an input that comes nearer than all before it is kept. method: its place among
/// those traced, below kMethods. Does nothing where the environment has CCDFUZZ_WITHOUT_MARGINS,
/// for comparison.
class Margins {
 public:
  static constexpr std::size_t kMethods = 6;
  /// Margins and slacks from 2^-64 to 2^64 of their unit, in buckets of four doublings.
  static constexpr std::size_t kBuckets = 32;
  static constexpr std::size_t kLevels = 24;  ///< the last is for all that are deeper
  static constexpr std::size_t kPerMethod = kLevels * kBuckets * 2;
  static constexpr std::size_t kCounters = kMethods * kPerMethod;  ///< those of a method together

  static void note(std::size_t method, const Trace& trace);
};

}  // namespace ccdfuzz
