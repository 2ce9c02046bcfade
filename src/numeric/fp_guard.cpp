#include "numeric/fp_guard.hpp"

#include <cfenv>
#include <limits>

#if defined(__SSE2__)
#include <immintrin.h>
#endif

namespace ccdfuzz {

namespace {

#if defined(__SSE2__)
constexpr unsigned kFlushBits = 0x8040;  // MXCSR: FTZ (bit 15) and DAZ (bit 6)
unsigned read_control() {
  return _mm_getcsr();
}
void write_control(unsigned bits) {
  _mm_setcsr(bits);
}
#else
constexpr unsigned kFlushBits = 0;
unsigned read_control() {
  return 0;
}
void write_control(unsigned) {}
#endif

}  // namespace

FpGuard::FpGuard() : rounding_(std::fegetround()), control_(read_control()) {
  std::fesetround(FE_TONEAREST);
  write_control(read_control() & ~kFlushBits);
}

FpGuard::~FpGuard() {
  std::fesetround(rounding_);
  write_control(control_);
}

bool fp_environment_is_sound() {
  volatile double smallest_normal = std::numeric_limits<double>::min();
  return std::fegetround() == FE_TONEAREST && smallest_normal / 2 != 0.0;
}

}  // namespace ccdfuzz
