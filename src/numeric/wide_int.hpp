#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <compare>
#include <cstddef>
#include <cstdint>

namespace ccdfuzz {

/// A two's complement integer of Bits bits, on the stack. Arithmetic is modulo 2^Bits. It is
/// therefore exact whenever the true result x satisfies −2^(Bits−1) ≤ x < 2^(Bits−1). Whoever
/// chooses Bits proves that; intermediate sums may leave the range as long as the result does not.
/// Only what exact predicates need; for anything else use Integer.
template <int Bits>
class WideInt {
  static_assert(Bits >= 128 && Bits % 64 == 0);
  static constexpr int kLimbs = Bits / 64;
  __extension__ using Double = unsigned __int128;  // product of two limbs
  using Limb = std::uint64_t;

 public:
  WideInt() = default;  // uninitialised, as a built-in integer is
  constexpr explicit WideInt(std::int64_t x) {
    limbs_.fill(x < 0 ? ~Limb{0} : 0);
    limbs_[0] = static_cast<Limb>(x);
  }
  /// Has the same value.
  template <int Less>
  requires(Less < Bits) constexpr explicit WideInt(const WideInt<Less>& x) {
    limbs_.fill(x.negative() ? ~Limb{0} : 0);
    std::copy_n(x.limbs_.begin(), Less / 64, limbs_.begin());
  }

  /// −1, 0 or 1.
  constexpr int sign() const {
    if (negative()) return -1;
    Limb any = 0;
    for (const Limb limb : limbs_) any |= limb;
    return any != 0 ? 1 : 0;
  }

  friend constexpr int sgn(const WideInt& x) { return x.sign(); }

  /// Within a relative error of 2^-52. No integer of less than 2^960 overflows.
  double approximate() const {
    static_assert(Bits < 960);
    // The highest limb of the magnitude that is not 0, and the next.
    const Limb flip = negative() ? ~Limb{0} : 0;
    Limb carry = flip & 1, top = 0, next = 0, before = 0;
    int place = 0;
    for (int i = 0; i < kLimbs; ++i) {
      const Limb limb = (limbs_[static_cast<std::size_t>(i)] ^ flip) + carry;
      carry = carry != 0 && limb == 0;
      next = limb != 0 ? before : next;
      place = limb != 0 ? i : place;
      top = limb != 0 ? limb : top;
      before = limb;
    }
    if (top == 0) return 0;
    // 64 leading bits: what is left out is less than 2^-63 of them, and their rounding 2^-53.
    const int zeros = std::countl_zero(top);
    const auto leading = static_cast<double>(top << zeros | next >> 1 >> (63 - zeros));
    const auto unit = std::bit_cast<double>(static_cast<Limb>(1023 + 64 * place - zeros) << 52);
    return flip != 0 ? -(leading * unit) : leading * unit;
  }

  /// Limb i, least significant first.
  constexpr std::uint64_t limb(int i) const { return limbs_[static_cast<std::size_t>(i)]; }

  friend constexpr WideInt operator+(WideInt a, const WideInt& b) { return a += b; }
  friend constexpr WideInt operator-(WideInt a, const WideInt& b) { return a -= b; }
  friend constexpr WideInt operator*(WideInt a, std::int64_t b) { return a *= b; }
  /// The product, which always fits.
  template <int Others>
  constexpr WideInt<Bits + Others> operator*(const WideInt<Others>& b) const {
    constexpr std::size_t kOthers = Others / 64;
    WideInt<Bits + Others> r(0);
    for (std::size_t i = 0; i < kLimbs; ++i) {
      Limb carry = 0;
      for (std::size_t j = 0; j < kOthers; ++j) {
        const Double product = Double{limbs_[i]} * b.limbs_[j] + r.limbs_[i + j] + carry;
        r.limbs_[i + j] = static_cast<Limb>(product);
        carry = static_cast<Limb>(product >> 64);
      }
      r.limbs_[i + kOthers] = carry;
    }
    // Read as unsigned, a negative number is 2^(its bits) more.
    r.template subtract_above<kLimbs>(b, negative());
    r.template subtract_above<kOthers>(*this, b.negative());
    return r;
  }
  friend constexpr WideInt operator<<(WideInt a, int shift) { return a <<= shift; }
  constexpr WideInt operator-() const { return WideInt(0) - *this; }

  constexpr WideInt& operator+=(const WideInt& o) {
    Limb carry = 0;
    for (std::size_t i = 0; i < kLimbs; ++i) {
      const Double sum = Double{limbs_[i]} + o.limbs_[i] + carry;
      limbs_[i] = static_cast<Limb>(sum);
      carry = static_cast<Limb>(sum >> 64);
    }
    return *this;
  }

  constexpr WideInt& operator-=(const WideInt& o) {
    subtract_above<0>(o, true);
    return *this;
  }

  /// Modulo 2^Bits a negative b is b + 2^64 − 2^64: the product with its bits read as unsigned,
  /// less 2^64 times this number.
  constexpr WideInt& operator*=(std::int64_t b) {
    const WideInt before = *this;
    Limb carry = 0;
    for (std::size_t i = 0; i < kLimbs; ++i) {
      const Double product = Double{limbs_[i]} * static_cast<Limb>(b) + carry;
      limbs_[i] = static_cast<Limb>(product);
      carry = static_cast<Limb>(product >> 64);
    }
    if (b < 0) subtract_above<1>(before, true);
    return *this;
  }

  /// Requires 0 ≤ shift < Bits.
  constexpr WideInt& operator<<=(int shift) {
    const auto limbs = static_cast<std::size_t>(shift / 64);
    const int bits = shift % 64;
    for (std::size_t i = kLimbs; i-- > 0;) {
      const Limb high = i >= limbs ? limbs_[i - limbs] : 0;
      const Limb low = i >= limbs + 1 ? limbs_[i - limbs - 1] : 0;
      limbs_[i] = bits == 0 ? high : high << bits | low >> (64 - bits);
    }
    return *this;
  }

  friend constexpr bool operator==(const WideInt&, const WideInt&) = default;
  friend constexpr std::strong_ordering operator<=>(const WideInt& a, const WideInt& b) {
    if (a.negative() != b.negative()) return b.negative() <=> a.negative();
    for (std::size_t i = kLimbs; i-- > 0;) {
      if (a.limbs_[i] != b.limbs_[i]) return a.limbs_[i] <=> b.limbs_[i];
    }
    return std::strong_ordering::equal;
  }

 private:
  template <int>
  friend class WideInt;

  /// Takes x·2^(64·Place) away, or nothing.
  template <std::size_t Place, int Less>
  constexpr void subtract_above(const WideInt<Less>& x, bool at_all) {
    const Limb mask = at_all ? ~Limb{0} : 0;
    Limb borrow = 0;
    for (std::size_t i = 0; i < std::min<std::size_t>(Less / 64, kLimbs - Place); ++i) {
      const Double difference = Double{limbs_[Place + i]} - (x.limbs_[i] & mask) - borrow;
      limbs_[Place + i] = static_cast<Limb>(difference);
      borrow = static_cast<Limb>(difference >> 64) & 1;
    }
  }

  constexpr bool negative() const { return limbs_[kLimbs - 1] >> 63 != 0; }

  std::array<Limb, kLimbs> limbs_;
};

}  // namespace ccdfuzz
