#pragma once

#include <cstdint>

#include "base/result.hpp"

namespace ccdfuzz {

struct NamedCase;

/// The limit of this process for checking the cases of files, all together. So a file of many
/// costly cases cannot occupy a command for long. Work bounds each certificate alone.
class RunWork {
 public:
  /// The limit is kStart and the lesser of two: kEachCase per case so far, and kEachByte per byte
  /// of its files. kStart is one of the costliest certificates. The unit is operations on 64-bit
  /// words. Measured means per case: 6·10^6 in the paper's set, 23·10^6 after `prove`, 67·10^6 in
  /// the first 1,000 of FF (some 600 bytes each, compressed). Two tensor(8,8) take 88·10^6.
  static constexpr std::uint64_t kStart = std::uint64_t{1} << 32;
  static constexpr std::uint64_t kEachCase = std::uint64_t{1} << 27;
  static constexpr std::uint64_t kEachByte = std::uint64_t{1} << 18;

  /// Adds what checking the case took, by work_done_here() before and after. Called in the order of
  /// the cases by one thread at a time, so that the sum does not depend on threads. Among
  /// consecutive calls for one case the largest counts. Errors: past the limit, naming the case and
  /// the limit.
  static Result<void> add(const NamedCase& named, std::uint64_t work);
  /// Sets another limit, however many cases there are.
  static void allow(std::uint64_t most);
};

}  // namespace ccdfuzz
