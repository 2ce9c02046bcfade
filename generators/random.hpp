#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <initializer_list>

#include "base/verify.hpp"
#include "numeric/dyadic.hpp"
#include "numeric/eigen_traits.hpp"

namespace ccdfuzz {

/// The project's own stream of random numbers: a counter put through a 64-bit mixer (SplitMix64).
/// The standard library's distributions differ between implementations; this one gives the same
/// draws everywhere. One draw per statement: the order in which a compiler evaluates the arguments
/// of a call is its own affair.
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

  /// Uniform in [lo, hi], both included; hi − lo < 2^63.
  std::int64_t between(std::int64_t lo, std::int64_t hi) {
    CCDFUZZ_ASSERT(lo <= hi);
    return lo + static_cast<std::int64_t>(below(static_cast<std::uint64_t>(hi - lo) + 1));
  }

  bool coin() { return (next() >> 63) != 0; }

  /// Uniform on the multiples of 2^exponent in [−2^(bits+exponent), 2^(bits+exponent)]; bits ≤ 61.
  Dyadic dyadic(int bits, long exponent) {
    const std::int64_t bound = std::int64_t{1} << bits;
    return {Integer(static_cast<long>(between(-bound, bound))), exponent};
  }

  Vec3<Dyadic> vector(int bits, long exponent) {
    Vec3<Dyadic> v;
    for (int k = 0; k < 3; ++k) v[k] = dyadic(bits, exponent);
    return v;
  }

  template <class T, std::size_t N>
  const T& pick(const std::array<T, N>& from) {
    return from[below(N)];
  }

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
