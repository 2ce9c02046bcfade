// Exits 0 iff double arithmetic is what the error bounds assume: IEEE 754 binary64, every operation
// rounded once, gradual underflow, no contraction, no reassociation.
#include <cfenv>
#include <cfloat>
#include <limits>

#ifdef __FAST_MATH__
#error "-ffast-math invalidates every bound"
#endif

// volatile inputs keep the compiler from folding; the outputs are plain so that it may contract.
static double product_sum(double a, double b, double c) { return a * b + c; }
static double sum3(double a, double b, double c) { return (a + b) + c; }

int main() {
  static_assert(std::numeric_limits<double>::is_iec559 && DBL_MANT_DIG == 53);
  static_assert(FLT_EVAL_METHOD == 0);
  volatile double x = 1.0 + 0x1p-30, minus_square = -(1.0 + 0x1p-29);
  if (product_sum(x, x, minus_square) != 0.0) return 1;  // fused: 2^-60
  volatile double big = 0x1p53, one = 1.0;
  if (sum3(big, one, -big) != 0.0) return 2;  // reassociated: 1
  volatile double smallest_normal = DBL_MIN;
  if (smallest_normal / 2 == 0.0) return 3;  // flushed to zero
  return std::fegetround() == FE_TONEAREST ? 0 : 4;
}
