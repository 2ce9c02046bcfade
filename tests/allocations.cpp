#include "allocations.hpp"

#include <malloc.h>

#include <atomic>
#include <cstdlib>
#include <new>

namespace {

std::atomic<long> count = 0, bytes = 0, peak = 0;

void add_bytes(long more) {
  const long now = bytes += more;
  for (long most = peak; now > most && !peak.compare_exchange_weak(most, now);) {
  }
}

void* counted(size_t size) {
  ++count;
  void* const p = std::malloc(size);
  add_bytes(static_cast<long>(malloc_usable_size(p)));
  return p;
}

void release(void* p) {
  add_bytes(-static_cast<long>(malloc_usable_size(p)));
  std::free(p);
}

}  // namespace

// In a file of their own, so that none is inlined into a caller without its counterpart.
void* operator new(size_t size) {
  if (void* p = counted(size == 0 ? 1 : size)) return p;
  throw std::bad_alloc();
}
void operator delete(void* p) noexcept {
  release(p);
}
void operator delete(void* p, size_t) noexcept {
  release(p);
}

namespace ccdfuzz {

long allocations() {
  return count;
}
long allocated_bytes() {
  return bytes;
}
long peak_allocated_bytes() {
  return peak;
}
void begin_peak() {
  peak = bytes.load();
}

}  // namespace ccdfuzz
