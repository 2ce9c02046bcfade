#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "base/verify.hpp"

namespace ccdfuzz {

/// A signed integer of at most Bits bits on the stack. Operations cost what the numbers at hand are
/// long, not what Bits allows. Results are exact; whoever chooses Bits proves that all fit, and one
/// that does not throws InternalError. A product needs the limbs of both factors together: that may
/// be one limb more than the result has.
template <int Bits>
class BoundedInt {
  static_assert(Bits > 0 && Bits % 64 == 0);
  static constexpr int kLimbs = Bits / 64;
  static constexpr int kShort = std::min(kLimbs, 8);
  __extension__ using Double = unsigned __int128;  // product of two limbs
  using Limb = std::uint64_t;

 public:
  /// A number as mantissa·2^exponent; a mantissa of 0, or ½ ≤ |mantissa| ≤ 1.
  struct Approximation {
    double mantissa;
    int exponent;
  };

  /// 0.
  BoundedInt() { std::fill_n(limbs_.begin(), kShort, Limb{0}); }
  explicit BoundedInt(std::int64_t x) : BoundedInt() {
    size_ = x != 0;
    negative_ = x < 0;
    limbs_[0] = x < 0 ? -static_cast<Limb>(x) : static_cast<Limb>(x);
  }
  BoundedInt(const BoundedInt& o) { *this = o; }
  BoundedInt& operator=(const BoundedInt& o) {
    size_ = o.size_;
    negative_ = o.negative_;
    // Most are short, and a known count is no call.
    if (size_ <= kShort) {
      std::copy_n(o.limbs_.begin(), kShort, limbs_.begin());
    } else {
      std::copy_n(o.limbs_.begin(), size_, limbs_.begin());
    }
    return *this;
  }
  ~BoundedInt() = default;

  /// Limbs of the magnitude, least significant first.
  int limbs() const { return size_; }
  std::uint64_t limb(int i) const { return limbs_[static_cast<std::size_t>(i)]; }

  /// −1, 0 or 1.
  int sign() const { return size_ == 0 ? 0 : negative_ ? -1 : 1; }

  /// Within a relative error of 2^-52.
  Approximation approximate() const {
    if (size_ == 0) return {0, 0};
    // The 64 leading bits: what is left out is less than 2^-63 of them, and their rounding 2^-53.
    const Limb top = limb(size_ - 1), next = size_ > 1 ? limb(size_ - 2) : 0;
    const int zeros = std::countl_zero(top);
    const Limb bits = zeros == 0 ? top : top << zeros | next >> (64 - zeros);
    const double mantissa = std::ldexp(static_cast<double>(bits), -64);
    return {negative_ ? -mantissa : mantissa, 64 * size_ - zeros};
  }

  BoundedInt operator-() const {
    BoundedInt r = *this;
    r.negative_ = !negative_;
    return r;
  }
  BoundedInt& operator+=(const BoundedInt& o) { return add(o, o.negative_); }
  BoundedInt& operator-=(const BoundedInt& o) { return add(o, !o.negative_); }
  friend BoundedInt operator+(BoundedInt a, const BoundedInt& b) { return a += b; }
  friend BoundedInt operator-(BoundedInt a, const BoundedInt& b) { return a -= b; }

  friend BoundedInt operator*(const BoundedInt& a, const BoundedInt& b) {
    BoundedInt r;
    if (a.size_ == 0 || b.size_ == 0) return r;
    r.resize(a.size_ + b.size_);
    std::fill_n(r.limbs_.begin(), r.size_, Limb{0});
    for (int i = 0; i < a.size_; ++i) {
      Limb carry = 0;
      for (int j = 0; j < b.size_; ++j) {
        const Double product = Double{a.limb(i)} * b.limb(j) + r.limb(i + j) + carry;
        r.limb(i + j) = static_cast<Limb>(product);
        carry = static_cast<Limb>(product >> 64);
      }
      r.limb(i + b.size_) = carry;
    }
    r.negative_ = a.negative_ != b.negative_;
    r.trim();
    return r;
  }

  friend BoundedInt operator*(const BoundedInt& a, std::int64_t b) { return a * BoundedInt(b); }

  /// Requires shift ≥ 0.
  friend BoundedInt operator<<(const BoundedInt& a, int shift) {
    BoundedInt r;
    if (a.size_ == 0) return r;
    const int limbs = shift / 64, bits = shift % 64;
    const Limb over = bits == 0 ? 0 : a.limb(a.size_ - 1) >> (64 - bits);
    r.resize(a.size_ + limbs + (over != 0));
    std::fill_n(r.limbs_.begin(), limbs, Limb{0});
    Limb carry = 0;
    for (int i = 0; i < a.size_; ++i) {
      r.limb(i + limbs) = a.limb(i) << bits | carry;
      carry = bits == 0 ? 0 : a.limb(i) >> (64 - bits);
    }
    if (over != 0) r.limb(r.size_ - 1) = over;
    r.negative_ = a.negative_;
    return r;
  }

 private:
  Limb& limb(int i) { return limbs_[static_cast<std::size_t>(i)]; }

  void resize(int size) {
    CCDFUZZ_VERIFY(size <= kLimbs);
    size_ = size;
  }
  void trim() {
    while (size_ > 0 && limb(size_ - 1) == 0) --size_;
  }

  /// Adds a number of o's magnitude.
  BoundedInt& add(const BoundedInt& o, bool o_negative) {
    if (negative_ == o_negative) {
      add_magnitude(o);
    } else if (less_in_magnitude(*this, o)) {
      subtract_magnitudes(o, *this);
      negative_ = o_negative;
    } else {
      subtract_magnitudes(*this, o);
    }
    return *this;
  }

  static bool less_in_magnitude(const BoundedInt& a, const BoundedInt& b) {
    if (a.size_ != b.size_) return a.size_ < b.size_;
    for (int i = a.size_; i-- > 0;) {
      if (a.limb(i) != b.limb(i)) return a.limb(i) < b.limb(i);
    }
    return false;
  }

  void add_magnitude(const BoundedInt& o) {
    for (; size_ < o.size_; ++size_) limb(size_) = 0;
    Limb carry = 0;
    for (int i = 0; i < o.size_; ++i) {
      const Double sum = Double{limb(i)} + o.limb(i) + carry;
      limb(i) = static_cast<Limb>(sum);
      carry = static_cast<Limb>(sum >> 64);
    }
    for (int i = o.size_; carry != 0 && i < size_; ++i) carry = ++limb(i) == 0;
    if (carry != 0) {
      resize(size_ + 1);
      limb(size_ - 1) = carry;
    }
  }

  /// Becomes |a| − |b|; requires |a| ≥ |b|. One of them may be *this.
  void subtract_magnitudes(const BoundedInt& a, const BoundedInt& b) {
    const int size = a.size_, common = b.size_;
    Limb borrow = 0;
    for (int i = 0; i < common; ++i) {
      const Double difference = Double{a.limb(i)} - b.limb(i) - borrow;
      limb(i) = static_cast<Limb>(difference);
      borrow = static_cast<Limb>(difference >> 64) & 1;
    }
    for (int i = common; i < size; ++i) {
      const Limb from = a.limb(i);
      limb(i) = from - borrow;
      borrow = borrow != 0 && from == 0;
    }
    size_ = size;
    trim();
  }

  int size_ = 0;  ///< limbs in use, the last of which is not 0
  bool negative_ = false;
  std::array<Limb, kLimbs> limbs_;  ///< beyond kShort uninitialised until in use
};

}  // namespace ccdfuzz
