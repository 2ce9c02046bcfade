#pragma once

#include <fmt/format.h>

#include "numeric/rational.hpp"

namespace ccdfuzz {

/// A number as a message shows it: a long one by its beginning and what it is about.
inline std::string abbreviated(const Rational& x) {
  constexpr size_t kLongest = 60;
  std::string text = to_text(x);
  if (text.size() <= kLongest) return text;
  return fmt::format("{}… (about {})", text.substr(0, kLongest / 2), x.get_d());
}

}  // namespace ccdfuzz
