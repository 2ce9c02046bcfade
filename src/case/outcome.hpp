#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "base/enum_names.hpp"

namespace ccdfuzz {

/// How an answer stands against a truth.
enum class Outcome : std::uint8_t {
  kCorrect,
  kMissed,         ///< said "no contact" though one is proven: a false negative
  kLate,           ///< said "hit" at a time after a proven contact: a false negative too
  kFalsePositive,  ///< said "hit" though absence is proven
  kUndecided,      ///< gave up within its budget; never a false negative or positive
  kUnknown,        ///< the truth is absent or does not reach far enough
  kError,          ///< threw, crashed or returned nonsense (NaN, toi outside [0, t_max])
  kNotAsked,       ///< refused the query; counted apart, in no number of queries and in no rate
};

constexpr std::array<std::string_view, 8> names_of(Outcome) {
  return {"correct",   "missed",  "late",  "false_positive",
          "undecided", "unknown", "error", "not_asked"};
}
inline constexpr auto kAllOutcomes = all_of(Outcome{});

/// A false negative of either kind.
constexpr bool is_false_negative(Outcome o) {
  return o == Outcome::kMissed || o == Outcome::kLate;
}

/// Right or wrong: what rates count.
constexpr bool is_judged(Outcome o) {
  return o == Outcome::kCorrect || is_false_negative(o) || o == Outcome::kFalsePositive;
}

/// What counts against a method: missed, late, false_positive, error.
constexpr bool is_failure(Outcome o) {
  return is_false_negative(o) || o == Outcome::kFalsePositive || o == Outcome::kError;
}

}  // namespace ccdfuzz
