#pragma once

#include <fmt/format.h>

#include <cfenv>
#include <cstdint>
#include <span>
#include <string>

namespace ccdfuzz {

/// A floating-point environment that a host program may leave to our thread.
struct FpEnvironment {
  const char* name;
  std::uint32_t control;  ///< the control word of this machine: MXCSR, FPCR
  int rounding;  ///< as in <cfenv>, for what else there is (x87, which glibc's strtod obeys)
};

/// Flushing of results, of operands and of both, each rounding mode, traps of invalid operations,
/// divisions by zero and overflows, and all that at once.
std::span<const FpEnvironment> fp_environments();

/// Puts the calling thread into an environment for as long as it lives.
class InFpEnvironment {
 public:
  explicit InFpEnvironment(const FpEnvironment& environment);
  ~InFpEnvironment();
  InFpEnvironment(const InFpEnvironment&) = delete;
  InFpEnvironment& operator=(const InFpEnvironment&) = delete;

 private:
  std::fenv_t callers_;
};

/// The control word of the calling thread, without the flags of exceptions past.
std::uint32_t fp_control();

/// Calls text() as the thread is, and in every environment. Returns how the first text that differs
/// does; empty if none does. text must not format doubles, but their bits.
template <class Text>
std::string differs_in_some_environment(const Text& text) {
  const std::string expected = text();
  for (const FpEnvironment& environment : fp_environments()) {
    std::string got;
    std::uint32_t left = 0;
    {
      const InFpEnvironment in(environment);
      got = text();
      left = fp_control();
    }
    if (got != expected) return fmt::format("{}: {}\nbut else {}", environment.name, got, expected);
    if (left != environment.control) {
      return fmt::format("{}: leaves the control word {:#x}", environment.name, left);
    }
  }
  return "";
}

}  // namespace ccdfuzz
