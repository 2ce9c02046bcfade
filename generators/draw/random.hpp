#pragma once

#include <bit>
#include <cstdint>
#include <initializer_list>

#include "base/verify.hpp"

namespace ccdfuzz {

/// The project's own stream of random numbers: a counter put through a 64-bit mixer (SplitMix64).
/// The standard library's distributions differ between implementations; this one gives the same
/// draws everywhere.
class Random {
 public:
  /// The stream that belongs to a sequence of numbers, such as (seed, index, class). Different
  /// sequences give unrelated streams.
  static Random keyed(std::initializer_list<std::uint64_t> parts) {
    std::uint64_t key = 0;
    for (const std::uint64_t part : parts) key = mix((key ^ part) + kStep);
    return Random(key);
  }

  explicit Random(std::uint64_t key) : state_(key) {}

  std::uint64_t next() { return mix(state_ += kStep); }

  /// Uniform in [0, bound), bound ≥ 1: draws as many bits as bound − 1 has until the value fits, so
  /// no value is favoured.
  std::uint64_t below(std::uint64_t bound) {
    CCDFUZZ_ASSERT(bound >= 1);
    const int unused = std::countl_zero(bound - 1);
    if (unused == 64) return 0;
    std::uint64_t x;
    do {
      x = next() >> unused;
    } while (x >= bound);
    return x;
  }

  bool coin() { return (next() >> 63) != 0; }

 private:
  static constexpr std::uint64_t kStep = 0x9e3779b97f4a7c15;  // 2^64 divided by the golden ratio

  static constexpr std::uint64_t mix(std::uint64_t z) {
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
    z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
    return z ^ (z >> 31);
  }

  std::uint64_t state_;
};

}  // namespace ccdfuzz
