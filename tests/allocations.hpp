#pragma once

namespace ccdfuzz {

/// Allocations of this program so far, by operator new and, once count_gmp_allocations was called,
/// by GMP. For tests that link allocations.cpp.
long allocations();
/// Bytes that are allocated now, and the most that were since begin_peak().
long allocated_bytes();
long peak_allocated_bytes();
void begin_peak();
void count_gmp_allocations();

}  // namespace ccdfuzz
