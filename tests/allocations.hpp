#pragma once

namespace ccdfuzz {

/// Allocations of this program so far, by operator new. For tests that link allocations.cpp.
long allocations();
/// Bytes that are allocated now, and the most that were since begin_peak().
long allocated_bytes();
long peak_allocated_bytes();
void begin_peak();

}  // namespace ccdfuzz
