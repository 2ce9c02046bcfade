#pragma once

#include <cstdint>

namespace ccdfuzz {

/// The work of all checks on this thread so far, of those that were refused, too. The unit is
/// operations on 64-bit words.
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
