#pragma once

#include <cstdint>
#include <set>
#include <span>
#include <string>

namespace ccdfuzz {

/// Keeps inputs on which a method fails that does not claim otherwise, so that fuzzing continues.
/// They go to the folder that the environment variable CCDFUZZ_LOST names, if any, for `ccdfuzz
/// triage`.
class LostInputs {
 public:
  LostInputs();

  /// Writes the first input of each kind. kind: what tells failures apart.
  void keep(std::span<const std::uint8_t> bytes, const std::string& kind);

 private:
  std::string folder_;  ///< empty: keep nothing
  std::set<std::string> kinds_;
};

}  // namespace ccdfuzz
