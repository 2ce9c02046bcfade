#pragma once

#include <charconv>
#include <string>
#include <string_view>
#include <system_error>

#ifndef __cpp_lib_to_chars
#include <cctype>
#include <cfenv>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#endif

#include "base/fp_guard.hpp"

namespace ccdfuzz {

/// std::from_chars for a double, whatever the locale and the floating-point environment (its short
/// cut for few digits divides doubles); in hex without 0x in front. Standard
/// libraries that lack it, as those that fuzzing services bring along do, go by strtod.
inline std::from_chars_result read_double(const char* begin, const char* end, double& x,
                                          bool hex = false) {
  const FpGuard guard;
#ifdef __cpp_lib_to_chars
  return std::from_chars(begin, end, x, hex ? std::chars_format::hex : std::chars_format::general);
#else
  // No program of ours sets a locale, so that strtod reads as in "C".
  const bool starts_well =
      begin != end && *begin != '+' && std::isspace(static_cast<unsigned char>(*begin)) == 0;
  const std::string text = (hex ? "0x" : "") + std::string(begin, end);
  char* stop = nullptr;
  // glibc's rounds as the x87 control word says, which the guard leaves alone.
  std::fenv_t callers;
  std::fegetenv(&callers);
  std::fesetround(FE_TONEAREST);
  const double read = std::strtod(text.c_str(), &stop);
  std::fesetenv(&callers);
  const std::ptrdiff_t length = stop - text.c_str() - (hex ? 2 : 0);
  if (!starts_well || length <= 0) return {begin, std::errc::invalid_argument};
  const std::string_view digits(text.c_str() + (hex ? 2 : 0), stop);
  const bool has_digit = digits.find_first_of(hex ? "123456789abcdefABCDEF" : "123456789") <
                         digits.find_first_of(hex ? "pP" : "eE");
  if (std::isinf(read) || (read == 0 && has_digit)) {
    return {begin + length, std::errc::result_out_of_range};
  }
  x = read;
  return {begin + length, std::errc()};
#endif
}

}  // namespace ccdfuzz
