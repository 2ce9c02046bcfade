#pragma once

#include <fcntl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cstdint>

namespace ccdfuzz {

/// Whether this code's sanitizer reserves far more memory than it uses, so that what is reserved
/// cannot be limited.
#if defined(__SANITIZE_ADDRESS__)
inline constexpr bool kReservesMemory = true;
#elif defined(__has_feature)
inline constexpr bool kReservesMemory = __has_feature(address_sanitizer);
#else
inline constexpr bool kReservesMemory = false;
#endif

/// Limits what this process may use of a resource, for good, unless it is limited to less.
inline void limit_resource(int resource, rlim_t most) {
  rlimit now{};
  ::getrlimit(resource, &now);
  most = std::min({most, now.rlim_cur, now.rlim_max});  // RLIM_INFINITY is the largest
  now.rlim_cur = now.rlim_max = most;
  ::setrlimit(resource, &now);
}

/// A descriptor of the same file where code that counts on low ones hardly meets it: from 64 on, if
/// this process may have as many. -1: it has as many as it may.
inline int duplicate_out_of_the_way(int descriptor) {
  const int high = ::fcntl(descriptor, F_DUPFD_CLOEXEC, 64);
  return high >= 0 ? high : ::fcntl(descriptor, F_DUPFD_CLOEXEC, STDERR_FILENO + 1);
}

/// For a process that answers in place of another: limits its address space, if not 0, no core
/// file, no file that would fill the disk.
inline void limit_answering_process(std::uint64_t bytes) {
  if (bytes > 0) limit_resource(RLIMIT_AS, bytes);
  limit_resource(RLIMIT_CORE, 0);
  limit_resource(RLIMIT_FSIZE, rlim_t{16} << 20);
}

}  // namespace ccdfuzz
