#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "base/result.hpp"
#include "base/text.hpp"

namespace ccdfuzz {

/// A number as people write one on a command line: terms joined by + and −, each a decimal ("1e-6",
/// "1.5"), a hex-float ("0x1p-20") or a power of two ("2^-20"); "1+2^-30" is one number. Each term
/// is read to the nearest double and they are added from the left. Errors: anything else, a value
/// that is not finite, a power of two below 2^-1074, a term that rounding loses, as in 1+2^-60.
/// `where` is the option's name.
Result<double> parse_number(const std::string& where, const std::string& text);

/// More than 30 years: no limit of a run.
inline constexpr double kMostSeconds = 1e9;

/// One in (0, kMostSeconds]: how many seconds.
Result<double> parse_seconds(const std::string& where, const std::string& text);

/// The exponent e of a value 2^e. Errors: the value is no power of two.
Result<int> parse_power_of_two(const std::string& where, const std::string& text);

/// "7" is a whole number; "-1", "+7", "010", " 7" and "0x7" are none. Errors: it is not from least
/// to most.
Result<std::uint64_t> parse_whole(const std::string& where, const std::string& text,
                                  std::uint64_t least = 0,
                                  std::uint64_t most = std::numeric_limits<std::uint64_t>::max());

/// The items of a list with commas between, each as parse(where, item) has it. Errors: those of
/// parse; an item stands there twice.
template <class T>
Result<std::vector<T>> parse_list(const std::string& where, const std::string& text,
                                  Result<T> (*parse)(const std::string& where,
                                                     const std::string& item)) {
  std::vector<T> items;
  for (const std::string& one : texts_between(text)) {
    CCDFUZZ_TRY(T item, parse(where, one));
    if (std::ranges::find(items, item) != items.end()) {
      return input_error(where, one + " stands there twice");
    }
    items.push_back(std::move(item));
  }
  return items;
}

/// Errors: first + count is past 2^64 - 1, where the numbers of cases end. things: what is counted.
Result<void> check_room(std::uint64_t first, std::uint64_t count, const char* things);

}  // namespace ccdfuzz
