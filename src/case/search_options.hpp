#pragma once

#include <atomic>
#include <cstdint>
#include <limits>

namespace ccdfuzz {

/// Limits of one query; exhaustion is Undecided, with the earliest time at which a contact may
/// still be. max_pops, max_bytes and max_work are deterministic. With their defaults
/// generated queries are decided. Patches that coincide over an area need 4^depth pairs; for them
/// tdibm-c runs out of memory within about a second. While it answers, a solver holds at most
/// max_bytes, a sixth of it more, kGrowthBytes, and buffers below 12 MiB whose size follows from
/// the degrees. Between queries it keeps at most kKeptBytes of all that (numeric/block_array.hpp).
struct SearchOptions {
  /// From here on there is no limit of time. Finite: a caller built with -ffast-math may not have
  /// infinity at all, and what its compiler then stores in a default is any number.
  static constexpr double kNoTimeLimit = std::numeric_limits<double>::max();

  double precision = 1e-4;  ///< parameter width at which a pair of cells is a hit; in (0, 1]
  std::uint64_t max_pops = 1'000'000;   ///< pairs taken from the queue
  std::uint64_t max_bytes = 128 << 20;  ///< memory of the queue and, of tdibm-c, the cells
  /// Operations on 64-bit words that tdibm-rational spends where doubles do not decide: about a
  /// nanosecond each. Integers are as long as the exponents of a query are far apart.
  std::uint64_t max_work = kMostExactWork;
  /// Wall time, not NaN; the clock is read by counted work (Deadline), also while a pair is split.
  double max_seconds = kNoTimeLimit;
  /// The clock that max_seconds is of, in seconds; null: a steady one of the machine. For tests.
  double (*clock)() = nullptr;
  /// Once it is true, a method in another process is asked no more. It throws NoProcess, also where
  /// it takes long (ChildProgram::interrupted).
  const std::atomic<bool>* stop = nullptr;

  bool is_stopped() const { return stop != nullptr && *stop; }

  /// About a minute. Generated queries of two triangle(2) took up to 2^31, and of two tensor(8,8)
  /// up to 2^36. Integers of 512 bits counted a third as much when that was measured.
  static constexpr std::uint64_t kMostExactWork = std::uint64_t{1} << 36;

  /// What the memory may grow by from one look at max_bytes to the next.
  static constexpr std::uint64_t kGrowthBytes = 1 << 20;
};

}  // namespace ccdfuzz
