#include "case/refusal.hpp"

#include <fmt/format.h>

#include "base/double_parts.hpp"

namespace ccdfuzz {

namespace {

bool is_precision(double x) {
  return is_finite(x) && compare(x, 0) > 0 && compare(x, 1) <= 0;
}

}  // namespace

bool is_question(const Query& query, double precision, double max_seconds) {
  return is_precision(precision) && !is_nan(max_seconds) && is_valid(query);
}

bool is_taken(const Query& query, double precision, double max_seconds) {
  return !is_of_bodies(query) && is_question(query, precision, max_seconds);
}

Answer refusal(const Query& query, double precision, double max_seconds) {
  Answer answer;
  answer.verdict = Verdict::kRefused;
  if (const Result<void> valid = validate(query, ""); !valid) {
    answer.note = valid.error().message();
  } else if (!is_precision(precision)) {
    answer.note = fmt::format("precision: {} is not in (0, 1]", precision);
  } else if (is_nan(max_seconds)) {
    answer.note = fmt::format("max_seconds: {} is not a number", max_seconds);
  } else {
    answer.note = kNoBodies;
  }
  return answer;
}

}  // namespace ccdfuzz
