#include "corpus/failure.hpp"

#include <fmt/format.h>

#include "base/json_tree.hpp"
#include "base/json_write.hpp"

namespace ccdfuzz {

namespace {

std::string error_name_key(const std::string& method) {
  return "error of " + method;
}

std::string loss_key(const std::string& method) {
  return "loss of " + method;
}

/// A text among the further keys of the origin; "" if there is none.
std::string origin_text(const Case& value, const std::string& key) {
  const auto found = value.origin.more.find(key);
  if (found == value.origin.more.end()) return "";
  const Result<JsonValue> text = parse_json(found->second, "");
  return text ? text->text : "";
}

void set_origin_text(Case& value, const std::string& key, const std::string& text) {
  if (text.empty()) {
    value.origin.more.erase(key);
  } else {
    value.origin.more[key] = json_string(text);
  }
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
          fmt::format("{} {} {} {}", name_of(outcome), origin.kind, origin.generator,
                      origin_text(value, loss_key(method)))};
}

std::set<FailureKey> failures_of(const Case& value) {
  std::set<FailureKey> keys;
  for (const auto& [method, outcome] : value.expect) {
    if (is_failure(outcome)) keys.insert(failure_key(value, method, outcome));
  }
  return keys;
}

std::string error_name(const Case& value, const std::string& method) {
  return origin_text(value, error_name_key(method));
}

void set_error_name(Case& value, const std::string& method, const std::string& name) {
  set_origin_text(value, error_name_key(method), name);
}

void set_loss(Case& value, const std::string& method, const std::string& loss) {
  set_origin_text(value, loss_key(method), loss);
}

}  // namespace ccdfuzz
