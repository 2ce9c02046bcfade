#pragma once

#include <fcntl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string_view>

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

/// Calls answer(line, replies) for each line of stdin, whose answer goes to the descriptor replies,
/// and ends this process after the last. For all other code stdin is empty, and stdout is stderr.
template <class Answer>
[[noreturn]] void answer_lines(const Answer& answer) {
  const int questions = duplicate_out_of_the_way(STDIN_FILENO);
  const int replies = duplicate_out_of_the_way(STDOUT_FILENO);
  const int nothing = ::open("/dev/null", O_RDONLY | O_CLOEXEC);
  if (questions < 0 || replies < 0 || nothing < 0 || ::dup2(nothing, STDIN_FILENO) < 0 ||
      ::dup2(STDERR_FILENO, STDOUT_FILENO) < 0) {
    std::_Exit(1);
  }
  FILE* const in = ::fdopen(questions, "r");
  char* line = nullptr;
  std::size_t room = 0;
  for (ssize_t length; (length = ::getline(&line, &room, in)) > 0;) {
    if (line[length - 1] == '\n') --length;
    answer(std::string_view(line, static_cast<std::size_t>(length)), replies);
  }
  std::_Exit(0);
}

/// For a process that answers in place of another: limits its address space, if not 0, no core
/// file, no file that would fill the disk.
inline void limit_answering_process(std::uint64_t bytes) {
  if (bytes > 0) limit_resource(RLIMIT_AS, bytes);
  limit_resource(RLIMIT_CORE, 0);
  limit_resource(RLIMIT_FSIZE, rlim_t{16} << 20);
}

}  // namespace ccdfuzz
