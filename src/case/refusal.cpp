#include "case/refusal.hpp"

#include <fmt/format.h>

#include "base/double_parts.hpp"

namespace ccdfuzz {

namespace {

bool is_precision(double x) {
  return is_finite(x) && compare(x, 0) > 0 && compare(x, 1) <= 0;
}

}  // namespace

bool is_question(const Query& query, const SearchOptions& options) {
  return is_precision(options.precision) && !is_nan(options.max_seconds) && is_valid(query);
}

bool is_taken(const Query& query, const SearchOptions& options) {
  return !is_of_bodies(query) && is_question(query, options);
}

Answer refusal(const Query& query, const SearchOptions& options) {
  Answer answer;
  answer.verdict = Verdict::kRefused;
  if (const auto fault = fault_of(query)) {
    answer.note = fault->message();
  } else if (!is_precision(options.precision)) {
    answer.note = fmt::format("precision: {} is not in (0, 1]", options.precision);
  } else if (is_nan(options.max_seconds)) {
    answer.note = fmt::format("max_seconds: {} is not a number", options.max_seconds);
  } else {
    answer.note = kNoBodies;
  }
  return answer;
}

}  // namespace ccdfuzz
