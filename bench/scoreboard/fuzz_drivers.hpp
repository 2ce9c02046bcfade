#pragma once

#include "drivers.hpp"

namespace ccdfuzz {

#ifdef CCDFUZZ_HAS_FUZZER
inline constexpr bool kHasFuzzer = true;
#else
inline constexpr bool kHasFuzzer = false;
#endif

/// drive() of the two that are libFuzzer.
[[noreturn]] void drive_fuzzer(Driver driver, std::uint64_t seed, const DriveLimit& limit,
                               const std::function<void(const DriverRun&)>& done);

}  // namespace ccdfuzz
