#pragma once

#include <cstddef>

namespace ccdfuzz {

/// Of the cases of a long test, one in this many is looked at: all where code is optimised, few
/// under asserts and sanitizers, which take ten to thirty times as long.
#ifdef NDEBUG
inline constexpr std::size_t kOneIn = 1;
#else
inline constexpr std::size_t kOneIn = 16;
#endif

}  // namespace ccdfuzz
