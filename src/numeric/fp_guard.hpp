#pragma once

namespace ccdfuzz {

/// Puts this thread's floating-point environment into the state that every bound assumes (round to
/// nearest, gradual underflow), and restores the caller's state on leaving. A host program or a
/// plug-in may have changed either.
class FpGuard {
 public:
  FpGuard();
  ~FpGuard();
  FpGuard(const FpGuard&) = delete;
  FpGuard& operator=(const FpGuard&) = delete;

 private:
  int rounding_;
  unsigned control_;
};

/// True iff the calling thread rounds to nearest and keeps subnormals.
bool fp_environment_is_sound();

}  // namespace ccdfuzz
