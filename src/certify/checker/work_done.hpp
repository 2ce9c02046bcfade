#pragma once

#include <cstdint>

namespace ccdfuzz {

namespace work_detail {

inline thread_local std::uint64_t done_here = 0;

}  // namespace work_detail

/// The work of all checks on this thread so far, of those that were refused, too. The unit is
/// operations on 64-bit words.
inline std::uint64_t work_done_here() {
  return work_detail::done_here;
}
/// Adds to it what no certificate takes.
inline void do_work_here(std::uint64_t work) {
  work_detail::done_here += work;
}

/// What is checked on this thread while it lives does not count.
class UncountedWork {
 public:
  UncountedWork() : before_(work_done_here()) {}
  ~UncountedWork() { work_detail::done_here = before_; }
  UncountedWork(const UncountedWork&) = delete;
  UncountedWork& operator=(const UncountedWork&) = delete;

 private:
  std::uint64_t before_;
};

}  // namespace ccdfuzz
