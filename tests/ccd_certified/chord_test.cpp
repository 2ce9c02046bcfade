#include <cmath>

#include "ccd/certified/window_trim.hpp"
#include "numeric/rational.hpp"
#include "rapidcheck.hpp"

namespace ccdfuzz::certified {
namespace {

double any_fraction() {
  return std::ldexp(static_cast<double>(*rc::gen::arbitrary<std::uint64_t>()), -64);
}

/// The claim of DERIVATION.md, 4: what is dropped lies where the chord is below zero.
RC_GTEST_PROP(LawB, TheChordsRootIsNeverPastTheExactOne, ()) {
  const double t0 = any_fraction(), t1 = any_fraction();
  RC_PRE(t0 != t1);
  const int e0 = *rc::gen::inRange(-1070, 1), e1 = *rc::gen::inRange(-1070, 1);
  const double h0 = -std::ldexp(0.5 + any_fraction() / 2, e0);
  const double h1 =
      *rc::gen::element(0.0, std::ldexp(any_fraction(), e1), std::ldexp(any_fraction(), e0));
  const double root = chord_root(t0, h0, t1, h1);
  const Rational exact_root =
      exact(t0) + (exact(t1) - exact(t0)) * (-exact(h0)) / (exact(h1) - exact(h0));
  RC_LOG() << to_hex(t0) << " " << to_hex(h0) << " " << to_hex(t1) << " " << to_hex(h1) << " -> "
           << to_hex(root) << std::endl;
  if (t0 < t1) {
    RC_ASSERT(exact(root) <= exact_root);
    RC_ASSERT(root >= t0);
  } else {
    RC_ASSERT(exact(root) >= exact_root);
    RC_ASSERT(root <= t0);
  }
}

}  // namespace
}  // namespace ccdfuzz::certified
