#pragma once

#include <fmt/format.h>

#include <cstdint>

#include "base/result.hpp"
#include "base/time_limit.hpp"
#include "certify/checker/work_done.hpp"
#include "numeric/fraction.hpp"

namespace ccdfuzz {

/// The most work of checking one certificate, in operations on 64-bit words: at most a few seconds.
/// The largest measured are below 2^28: trees and planes of generated and proven cases of all
/// families, and planes of two tensor(8,8); witnesses stay below 2^23. So there is a factor of 16.
/// For two tensor(8,8) that is a tree of 120 splits, which takes 5 s to 8 s: the costliest of all.
inline constexpr std::uint64_t kMostWork = std::uint64_t{1} << 32;

inline std::uint64_t words_of(const Integer& x) {
  return mpz_size(x.get_mpz_t());
}
inline std::uint64_t words_of(const Rational& x) {
  return words_of(x.get_num()) + words_of(x.get_den());
}
inline std::uint64_t words_of(const Dyadic& x) {
  return words_of(x.mantissa());
}
/// Those of the Rational that it equals.
inline std::uint64_t words_of(const Fraction& x) {
  const auto shifted = [](const Integer& n, long by) -> std::uint64_t {
    if (by <= 0 || n == 0) return words_of(n);
    return (mpz_sizeinbase(n.get_mpz_t(), 2) + static_cast<std::uint64_t>(by) + 63) / 64;
  };
  const Dyadic& n = x.numerator();
  return shifted(n.mantissa(), n.exponent()) + shifted(x.odd_divisor(), -n.exponent());
}
inline std::uint64_t words_of(double) {
  return 1;
}

/// What adding a·b to a sum costs at most, up to a factor that is the same for all sizes.
template <class A, class B>
std::uint64_t product_work(const A& a, const B& b) {
  constexpr std::uint64_t kCalls = 16;  // calls and allocations, however small the numbers
  return kCalls + words_of(a) * words_of(b);
}
/// The same of fractions of so many words together, which are brought to lowest terms: greatest
/// common divisors of all that they are made of.
inline std::uint64_t fraction_work(std::uint64_t words) {
  constexpr std::uint64_t kCalls = 64;
  return kCalls + 4 * words * words;
}
inline std::uint64_t product_work(const Rational& a, const Rational& b) {
  return fraction_work(words_of(a) + words_of(b));
}
inline std::uint64_t product_work(const Fraction& a, const Fraction& b) {
  return fraction_work(words_of(a) + words_of(b));
}

/// Counts the work of one check, so that a small file cannot occupy the checker for long. It is
/// counted from the sizes of numbers: the same file is refused on every machine. Its end adds it to
/// work_done_here(). It looks at the TimeLimit of this thread at its start, and about every
/// millisecond.
class Work {
 public:
  /// Thrown by charge, and caught by within_work.
  struct Exceeded {
    std::uint64_t most;
  };

  explicit Work(std::uint64_t most) : most_(most), left_(most) { TimeLimit::stop_if_late(); }
  Work(const Work&) = delete;
  Work& operator=(const Work&) = delete;
  ~Work() { do_work_here(most_ - left_); }

  void charge(std::uint64_t words) {
    if (words > left_) {
      left_ = 0;
      throw Exceeded{most_};
    }
    left_ -= words;
    not_looked_ += words;
    if (not_looked_ < kBetweenLooks) return;
    not_looked_ = 0;
    TimeLimit::stop_if_late();
  }

 private:
  static constexpr std::uint64_t kBetweenLooks = 1 << 20;

  std::uint64_t most_, left_, not_looked_ = 0;
};

/// check(of..., work). Errors: those of check; it exceeds the budget, naming `where` (is_limit).
template <class Check, class... Of>
auto within_work(const char* where, std::uint64_t most, const Check& check, const Of&... of)
    -> decltype(check(of..., std::declval<Work&>())) {
  Work work(most);
  try {
    return check(of..., work);
  } catch (const Work::Exceeded&) {
    return tl::unexpected<InputError>(
        {where, fmt::format("exceeds the work budget of {} operations on 64-bit words", most),
         true});
  }
}

}  // namespace ccdfuzz
