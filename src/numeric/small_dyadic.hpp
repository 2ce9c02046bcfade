#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <optional>

#include "base/double_parts.hpp"
#include "numeric/dyadic.hpp"
#include "numeric/exact_scalars.hpp"

namespace ccdfuzz {

/// The exact number m·2^k with |m| < 2^126, on the stack: a Dyadic wherever it fits, which it
/// nearly always does. A result that does not fit is lost, and so is all that is made of it: fits()
/// tells.
class SmallDyadic {
 public:
  SmallDyadic() = default;
  SmallDyadic(int m) : m_(m) { normalise(); }  // NOLINT: integers convert as in any number type

  /// Requires x finite.
  static SmallDyadic exact(double x) {
    const DoubleParts parts = parts_of(x);
    SmallDyadic out;
    out.m_ = parts.mantissa;
    out.k_ = parts.exponent;
    return out;
  }
  static SmallDyadic of(const Dyadic& x) {
    SmallDyadic out;
    const Integer& m = x.mantissa();
    out.fits_ = m.fits_slong_p();
    out.m_ = m.get_si();
    out.k_ = x.exponent();
    return out;
  }

  bool fits() const { return fits_; }
  int sign() const { return m_ == 0 ? 0 : m_ < 0 ? -1 : 1; }

  /// Requires fits().
  Dyadic dyadic() const {
    const bool negative = m_ < 0;
    const auto magnitude = static_cast<Unsigned>(negative ? -m_ : m_);
    Integer m = static_cast<unsigned long>(magnitude >> 64);
    if (m != 0) mpz_mul_2exp(m.get_mpz_t(), m.get_mpz_t(), 64);
    m += static_cast<unsigned long>(magnitude);
    return Dyadic(negative ? Integer(-m) : m, k_);
  }

  /// The double equal to this number, if there is one. Requires fits().
  std::optional<double> to_double_exactly() const {
    const int bits = width(m_);
    if (bits > 53 || k_ < -1074 || k_ + bits > 1024) return std::nullopt;
    return std::ldexp(static_cast<double>(static_cast<std::int64_t>(m_)), static_cast<int>(k_));
  }

  /// This number over another. nullopt if that is not dyadic. Requires by ≠ 0, which fits.
  std::optional<SmallDyadic> divided(const SmallDyadic& by) const {
    if (!fits_) return *this;
    if (m_ % by.m_ != 0) return std::nullopt;
    SmallDyadic out = scaled(-by.k_);
    out.m_ /= by.m_;
    return out;
  }
  SmallDyadic scaled(long shift) const {
    SmallDyadic out = *this;
    if (m_ != 0) out.k_ += shift;
    return out;
  }

  SmallDyadic operator-() const {
    SmallDyadic out = *this;
    out.m_ = -m_;
    return out;
  }

  SmallDyadic& operator*=(const SmallDyadic& o) {
    fits_ = fits_ && o.fits_ && width(m_) + width(o.m_) <= kMostBits;
    if (!fits_) return *this;
    m_ *= o.m_;
    k_ = m_ == 0 ? 0 : k_ + o.k_;
    return *this;
  }

  SmallDyadic& operator+=(const SmallDyadic& o) {
    fits_ = fits_ && o.fits_;
    if (!fits_ || o.m_ == 0) return *this;
    if (m_ == 0) return *this = o;
    Signed other = o.m_;
    const long unit = std::min(k_, o.k_);
    shift_up(m_, k_ - unit);
    shift_up(other, o.k_ - unit);
    if (!fits_) return *this;
    k_ = unit;
    m_ += other;
    normalise();
    return *this;
  }
  SmallDyadic& operator-=(const SmallDyadic& o) { return *this += -o; }

  /// Requires that both fit.
  friend bool operator==(const SmallDyadic& a, const SmallDyadic& b) {
    return a.m_ == b.m_ && a.k_ == b.k_;
  }
  friend SmallDyadic operator+(SmallDyadic a, const SmallDyadic& b) { return a += b; }
  friend SmallDyadic operator-(SmallDyadic a, const SmallDyadic& b) { return a -= b; }
  friend SmallDyadic operator*(SmallDyadic a, const SmallDyadic& b) { return a *= b; }

 private:
  __extension__ using Signed = __int128;
  __extension__ using Unsigned = unsigned __int128;
  /// The bits of summands and products. A sum of two then has one more, and its sign bit is left.
  static constexpr int kMostBits = 125;

  static int width(Signed m) {
    const auto magnitude = static_cast<Unsigned>(m < 0 ? -m : m);
    const auto high = static_cast<std::uint64_t>(magnitude >> 64);
    return high != 0 ? 64 + static_cast<int>(std::bit_width(high))
                     : static_cast<int>(std::bit_width(static_cast<std::uint64_t>(magnitude)));
  }

  /// m·2^by, by ≥ 0; or lost.
  void shift_up(Signed& m, long by) {
    if (by > kMostBits || width(m) + by > kMostBits) {
      fits_ = false;
      return;
    }
    m = static_cast<Signed>(static_cast<Unsigned>(m) << by);
  }

  /// m odd, or m = k = 0.
  void normalise() {
    if (m_ == 0) {
      k_ = 0;
      return;
    }
    const auto low = static_cast<std::uint64_t>(m_);
    const int zeros =
        low != 0
            ? std::countr_zero(low)
            : 64 + std::countr_zero(static_cast<std::uint64_t>(static_cast<Unsigned>(m_) >> 64));
    m_ >>= zeros;
    k_ += zeros;
  }

  Signed m_ = 0;
  long k_ = 0;
  bool fits_ = true;
};

}  // namespace ccdfuzz

namespace Eigen {

template <>
struct NumTraits<ccdfuzz::SmallDyadic> : ExactNumTraits<ccdfuzz::SmallDyadic> {};

}  // namespace Eigen
