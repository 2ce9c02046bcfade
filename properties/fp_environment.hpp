#pragma once

#include <cfenv>
#include <cstdint>
#include <span>

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

}  // namespace ccdfuzz
