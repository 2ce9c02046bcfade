#include "corpus/failure.hpp"

#include <fmt/format.h>

#include "query/json_tree.hpp"

namespace ccdfuzz {

namespace {

std::string error_name_key(const std::string& method) {
  return "error of " + method;
}

}  // namespace

bool is_failure(Outcome outcome) {
  return is_false_negative(outcome) || outcome == Outcome::kFalsePositive ||
         outcome == Outcome::kError;
}

FailureKey failure_key(const Case& value, const std::string& method, Outcome outcome) {
  if (outcome == Outcome::kError) {
    return {method, "", fmt::format("{} {}", name_of(outcome), error_name(value, method))};
  }
  const Origin& origin = value.origin;
  return {method, origin.contact,
          fmt::format("{} {} {}", name_of(outcome), origin.kind, origin.generator)};
}

std::set<FailureKey> failures_of(const Case& value) {
  std::set<FailureKey> keys;
  for (const auto& [method, outcome] : value.expect) {
    if (is_failure(outcome)) keys.insert(failure_key(value, method, outcome));
  }
  return keys;
}

std::string error_name(const Case& value, const std::string& method) {
  const auto found = value.origin.more.find(error_name_key(method));
  if (found == value.origin.more.end()) return "";
  const Result<JsonValue> text = parse_json(found->second, "");
  return text ? text->text : "";
}

void set_error_name(Case& value, const std::string& method, const std::string& name) {
  if (name.empty()) {
    value.origin.more.erase(error_name_key(method));
  } else {
    value.origin.more[error_name_key(method)] = json_string(name);
  }
}

}  // namespace ccdfuzz
