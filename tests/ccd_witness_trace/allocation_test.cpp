#include <gmp.h>
#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <new>

#include "traced.hpp"

namespace {

std::atomic<long> allocations = 0;

void* counted(size_t size) {
  ++allocations;
  return std::malloc(size);
}

}  // namespace

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
namespace {

TEST(Trace, AllocatesNothingOnceWarm) {
  mp_set_memory_functions(
      counted,
      [](void* p, size_t, size_t size) {
        ++allocations;
        return std::realloc(p, size);
      },
      [](void* p, size_t) { std::free(p); });
  std::vector<Case> cases;
  for (std::uint64_t index = 0; index < 4; ++index) {
    cases.push_back(generated_case(ContactClass::kFF, Family::kRegular, index));
    cases.push_back(generated_case(ContactClass::kVE, Family::kInteriorTime, index));
  }
  for (const char* spec : kTraceable) {
    const auto tracer = tracer_of(spec);
    const auto trace_all = [&] {
      for (const Case& known : cases) {
        tracer->trace(known.query, *known.truth.witness, {.all = true});
      }
    };
    trace_all();
    const long before = allocations;
    trace_all();
    EXPECT_EQ(allocations - before, 0) << spec;
  }
  EXPECT_GT(allocations, 0) << "the counter counts";
}

}  // namespace
}  // namespace ccdfuzz
