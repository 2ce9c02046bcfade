#pragma once

#include <stdexcept>
#include <string>

namespace ccdfuzz {

/// A broken invariant of our own: never the fault of outside data.
struct InternalError : std::logic_error {
  using std::logic_error::logic_error;
};

[[noreturn]] inline void invariant_broken(const char* condition, const char* file, int line) {
  throw InternalError(std::string(file) + ":" + std::to_string(line) +
                      ": invariant broken: " + condition);
}

}  // namespace ccdfuzz

/// Checks an invariant in every build.
#define CCDFUZZ_VERIFY(condition)                      \
  (static_cast<bool>(condition) ? static_cast<void>(0) \
                                : ::ccdfuzz::invariant_broken(#condition, __FILE__, __LINE__))

/// Checks an invariant where asserts are on (tests, fuzzing); for hot paths.
#ifdef NDEBUG
#define CCDFUZZ_ASSERT(condition) static_cast<void>(0)
#else
#define CCDFUZZ_ASSERT(condition) CCDFUZZ_VERIFY(condition)
#endif
