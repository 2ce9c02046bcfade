#include "properties/fp_environment.hpp"

#include <array>

#if defined(__SSE2_MATH__)
#include <xmmintrin.h>
#endif

namespace ccdfuzz {

namespace {

#if defined(__SSE2_MATH__)
// MXCSR. Bits 7 to 12 mask exceptions: invalid (7), division by zero (9), overflow (10).
constexpr std::uint32_t kDefault = 0x1f80, kFlushResults = 0x8000, kFlushOperands = 0x40,
                        kDown = 0x2000, kUp = 0x4000, kTowardZero = 0x6000,
                        kTrapping = kDefault & ~std::uint32_t{0x680}, kFlags = 0x3f;
std::uint32_t read() {
  return _mm_getcsr();
}
void write(std::uint32_t word) {
  _mm_setcsr(word);
}
#elif defined(__aarch64__)
// FPCR. FZ (24) flushes both; most machines cannot trap.
constexpr std::uint32_t kDefault = 0, kFlushResults = 1U << 24, kFlushOperands = 1U << 24,
                        kUp = 1U << 22, kDown = 2U << 22, kTowardZero = 3U << 22, kTrapping = 0,
                        kFlags = 0;
std::uint32_t read() {
  std::uint64_t word;
  asm volatile("mrs %0, fpcr" : "=r"(word));
  return static_cast<std::uint32_t>(word);
}
void write(std::uint32_t word) {
  asm volatile("msr fpcr, %0" : : "r"(std::uint64_t{word}) : "memory");
}
#endif

constexpr std::array<FpEnvironment, 9> kEnvironments = {{
    {"to nearest", kDefault, FE_TONEAREST},
    {"results flushed", kDefault | kFlushResults, FE_TONEAREST},
    {"operands flushed", kDefault | kFlushOperands, FE_TONEAREST},
    {"both flushed", kDefault | kFlushResults | kFlushOperands, FE_TONEAREST},
    {"upward", kDefault | kUp, FE_UPWARD},
    {"downward", kDefault | kDown, FE_DOWNWARD},
    {"toward zero", kDefault | kTowardZero, FE_TOWARDZERO},
    {"trapping", kTrapping, FE_TONEAREST},
    {"trapping, both flushed, upward", kTrapping | kFlushResults | kFlushOperands | kUp, FE_UPWARD},
}};

}  // namespace

std::span<const FpEnvironment> fp_environments() {
  return kEnvironments;
}

InFpEnvironment::InFpEnvironment(const FpEnvironment& environment) {
  std::fegetenv(&callers_);
  std::fesetround(environment.rounding);
  write(environment.control);
}

InFpEnvironment::~InFpEnvironment() {
  std::fesetenv(&callers_);
}

std::uint32_t fp_control() {
  return read() & ~kFlags;
}

}  // namespace ccdfuzz
