#pragma once

namespace ccdfuzz {

/// Allocations of this program so far, by operator new and, once count_gmp_allocations was called,
/// by GMP. For tests that link allocations.cpp.
long allocations();
void count_gmp_allocations();

}  // namespace ccdfuzz
