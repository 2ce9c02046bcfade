#pragma once

#include <cstdint>

#include "base/result.hpp"

namespace ccdfuzz {

struct NamedCase;

/// What this process may spend on checking the cases of files, all together, so that a file of many
/// costly cases cannot occupy a command for long. Work bounds each certificate alone.
class RunWork {
 public:
  /// The limit is kStart, one certificate of the costliest, and the lesser of kEachCase for each
  /// case so far and kEachByte for each byte of its files, in operations on 64-bit words. Measured,
  /// a case takes 6·10^6 in the mean of the paper's set and 23·10^6 once `prove` was there, the
  /// first 1,000 of FF 67·10^6, of some 600 bytes compressed, and two tensor(8,8) 88·10^6.
  static constexpr std::uint64_t kStart = std::uint64_t{1} << 32;
  static constexpr std::uint64_t kEachCase = std::uint64_t{1} << 27;
  static constexpr std::uint64_t kEachByte = std::uint64_t{1} << 18;

  /// Adds what checking the case took, by work_done_here() before and after. Called in the order of
  /// the cases by one thread at a time, so that the sum does not depend on threads; of calls in a
  /// row for one case the largest counts. Errors: past the limit, naming the case and the limit.
  static Result<void> add(const NamedCase& named, std::uint64_t work);
  /// Sets another limit, however many cases there are.
  static void allow(std::uint64_t most);
};

/// The work of all checks on this thread so far, of those that were refused, too.
std::uint64_t work_done_here();
/// Adds to it what no certificate takes.
void do_work_here(std::uint64_t work);

/// What is checked on this thread while it lives does not count.
class UncountedWork {
 public:
  UncountedWork() : before_(work_done_here()) {}
  ~UncountedWork();
  UncountedWork(const UncountedWork&) = delete;
  UncountedWork& operator=(const UncountedWork&) = delete;

 private:
  std::uint64_t before_;
};

}  // namespace ccdfuzz
