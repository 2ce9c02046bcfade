#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdlib>

namespace ccdfuzz {

/// Of the cases of a long test, one in this many is looked at: all where code is optimised, few
/// under asserts and sanitizers, which take ten to thirty times as long.
#ifdef NDEBUG
inline constexpr std::size_t kOneIn = 1;
#else
inline constexpr std::size_t kOneIn = 16;
#endif

/// CCDFUZZ_SEED, which main draws if it is "random". For tests whose claims hold of any draws.
inline std::uint64_t test_seed() {
  const char* const seed = std::getenv("CCDFUZZ_SEED");
  return seed == nullptr ? 1 : std::strtoull(seed, nullptr, 10);
}

}  // namespace ccdfuzz
