#pragma once

#include <fmt/format.h>

#include <cmath>

#include "numeric/rational.hpp"

namespace ccdfuzz {

/// A number as a message shows it: a long one by its beginning and what it is about.
inline std::string abbreviated(const Rational& x) {
  constexpr size_t kLongest = 60;
  std::string text = to_text(x);
  if (text.size() <= kLongest) return text;
  const double near = x.get_d();
  std::string about = fmt::format("{}", near);
  if (near == 0 || std::isinf(near)) {  // no double is near
    const auto bits = [](const Integer& n) {
      return static_cast<long>(mpz_sizeinbase(n.get_mpz_t(), 2));
    };
    about = fmt::format("{}2^{}", x < 0 ? "-" : "", bits(x.get_num()) - bits(x.get_den()));
  }
  return fmt::format("{}… (about {})", text.substr(0, kLongest / 2), about);
}

}  // namespace ccdfuzz
