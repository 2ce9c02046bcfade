// Exits 0 iff double arithmetic is what the error bounds assume: IEEE 754 binary64, every operation
// rounded once and in the order written, gradual underflow, NaN and infinity as they are; and iff
// what is said of bits holds in a thread that flushes subnormals.
#include <cfenv>
#include <cfloat>
#include <cstdint>
#include <cstring>
#include <limits>
#if defined(__SSE2_MATH__)
#include <xmmintrin.h>
#endif

#if defined(__FAST_MATH__) || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__)
#error "-ffast-math or a part of it invalidates every bound"
#endif

// volatile inputs keep the compiler from folding; the results are plain so that it may rewrite.
static double product_sum(double a, double b, double c) {
  return a * b + c;
}
static double round_to_integer(double a) {
  return (a + 0x1p53) - 0x1p53;
}
static double tenth(double a) {
  return a / 10.0;
}
static bool is_zero(double a) {
  std::uint64_t bits;
  std::memcpy(&bits, &a, sizeof bits);
  return bits << 1 == 0;
}

int main() {
  static_assert(std::numeric_limits<double>::is_iec559 && DBL_MANT_DIG == 53);
  static_assert(FLT_EVAL_METHOD == 0);
  volatile double x = 1.0 + 0x1p-30, minus_square = -(1.0 + 0x1p-29);
  if (product_sum(x, x, minus_square) != 0.0) return 1;  // fused: 2^-60
  volatile double half = 0.5;
  if (round_to_integer(half) != 0.0) return 2;  // reassociated: 0.5
  volatile double smallest_normal = DBL_MIN;
  if (smallest_normal / 2 == 0.0) return 3;  // flushed to zero
  volatile double three = 3.0;
  if (tenth(three) != 0.3) return 4;  // times the rounded reciprocal: 0.3 + 2^-54
#if defined(__SSE2_MATH__)
  volatile double subnormal = 0x1p-1074;
  const unsigned sound = _mm_getcsr();
  _mm_setcsr(sound | 0x8040);
  volatile bool vanished = is_zero(subnormal);
  _mm_setcsr(sound);
  if (vanished) return 6;  // a comparison of doubles
#endif
  return std::fegetround() == FE_TONEAREST ? 0 : 5;
}
