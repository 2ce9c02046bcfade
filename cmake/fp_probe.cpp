// Exits 0 iff double arithmetic is what the error bounds assume: IEEE 754 binary64, every operation
// rounded once and in the order written, gradual underflow, NaN and infinity as they are.
#include <cfenv>
#include <cfloat>
#include <limits>

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
  return std::fegetround() == FE_TONEAREST ? 0 : 5;
}
