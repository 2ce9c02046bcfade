#pragma once

// Included by every header with arithmetic that an error bound speaks of. Compiled with other
// rules, it would prove nothing; and the linker could take such a copy for the library's own. These
// headers are not installed.

#include <cfloat>

#if defined(__FAST_MATH__) || defined(__ASSOCIATIVE_MATH__) || defined(__RECIPROCAL_MATH__) || \
    (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__)
#error "-ffast-math, or a part of it: the error bounds of this header do not hold"
#endif
static_assert(FLT_EVAL_METHOD == 0, "doubles are evaluated as doubles, not in x87 registers");
