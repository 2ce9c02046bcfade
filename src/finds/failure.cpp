#include "finds/failure.hpp"

#include <fmt/format.h>

namespace ccdfuzz {

bool is_failure(Outcome outcome) {
  return is_false_negative(outcome) || outcome == Outcome::kFalsePositive ||
         outcome == Outcome::kError;
}

FailureKey failure_key(const Case& value, const std::string& method, const Expected& expected) {
  const auto& [outcome, cause] = expected;
  if (outcome == Outcome::kError) {
    return {method, "", fmt::format("{} {}", name_of(outcome), cause)};
  }
  const Origin& origin = value.origin;
  return {method, origin.contact,
          fmt::format("{} {} {} {}", name_of(outcome), origin.kind, origin.generator, cause)};
}

std::set<FailureKey> failures_of(const Case& value) {
  std::set<FailureKey> keys;
  for (const auto& [method, expected] : value.expect) {
    if (is_failure(expected.outcome)) keys.insert(failure_key(value, method, expected));
  }
  return keys;
}

}  // namespace ccdfuzz
