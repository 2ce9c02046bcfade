#include "allocations.hpp"

#include <gmp.h>

#include <atomic>
#include <cstdlib>
#include <new>

namespace {

std::atomic<long> count = 0;

void* counted(size_t size) {
  ++count;
  return std::malloc(size);
}

}  // namespace

// In a file of their own, so that none is inlined into a caller without its counterpart.
void* operator new(size_t size) {
  if (void* p = counted(size == 0 ? 1 : size)) return p;
  throw std::bad_alloc();
}
void operator delete(void* p) noexcept {
  std::free(p);
}
void operator delete(void* p, size_t) noexcept {
  std::free(p);
}

namespace ccdfuzz {

long allocations() {
  return count;
}

void count_gmp_allocations() {
  mp_set_memory_functions(
      counted,
      [](void* p, size_t, size_t size) {
        ++count;
        return std::realloc(p, size);
      },
      [](void* p, size_t) { std::free(p); });
}

}  // namespace ccdfuzz
