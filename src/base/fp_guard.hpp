#pragma once

#include <cstdint>
#if defined(__SSE2_MATH__) || defined(_M_X64)
#include <xmmintrin.h>
#endif

namespace ccdfuzz {

/// Puts this thread's floating-point environment into the state that every bound assumes: round to
/// nearest, gradual underflow, no exception traps. A host program, or a library that it loaded, may
/// have set another. The destructor restores the caller's. If the state is right already, that
/// costs one read of the control word. What is computed within must come from memory or go through
/// a call: a compiler may move arithmetic on registers across. (x86: the x87 control word stays as
/// it is; no arithmetic here is done there.)
class FpGuard {
 public:
  FpGuard() : callers_(read()) {
    if (!is_sound(callers_)) write(kSound);
  }
  ~FpGuard() {
    if (!is_sound(callers_)) write(callers_);
  }
  FpGuard(const FpGuard&) = delete;
  FpGuard& operator=(const FpGuard&) = delete;

  /// True iff the calling thread is in that state: what a function that needs a guard may assert.
  static bool holds() { return is_sound(read()); }

  /// The control word of the calling thread: MXCSR, FPCR.
#if defined(__SSE2_MATH__) || defined(_M_X64)
  using Word = std::uint32_t;
  static constexpr Word kSound = 0x1f80;    // MXCSR: all exceptions masked, nearest, no FTZ, no DAZ
  static constexpr Word kControl = 0xffc0;  // all but the flags of exceptions past
  static Word read() {
    return _mm_getcsr();
  }
  static void write(Word word) {
    stay_here();
    _mm_setcsr(word);
    stay_here();
  }
#elif defined(__aarch64__)
  using Word = std::uint64_t;
  static constexpr Word kSound = 0;  // FPCR: no traps, nearest, no FZ, no FIZ, no AH
  static constexpr Word kControl = ~Word{0};
  static Word read() {
    Word word;
    asm volatile("mrs %0, fpcr" : "=r"(word));
    return word;
  }
  static void write(Word word) {
    asm volatile("msr fpcr, %0" : : "r"(word) : "memory");
  }
#else
#error "fp_guard.hpp knows no floating-point control word of this machine: every bound rests on it"
#endif

 private:
  static bool is_sound(Word word) {
    return (word & kControl) == kSound;
  }
  /// Keeps the compiler from moving what goes through memory across.
  static void stay_here() {
    asm volatile("" : : : "memory");
  }

  Word callers_;
};

}  // namespace ccdfuzz
