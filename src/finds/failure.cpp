#include "finds/failure.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>

#include "io/hash_name.hpp"

namespace ccdfuzz {

namespace {

/// The text with each character replaced that a file name should not have. What the replacements
/// cannot tell apart, a hash does.
std::string plain(const std::string& text) {
  std::string out;
  bool is_ambiguous = text.starts_with('.');
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    const bool is_plain = byte < 128 && (std::isalnum(byte) != 0 || c == '.' || c == '-');
    is_ambiguous = is_ambiguous || (!is_plain && c != ':');
    out += is_plain ? c : c == ':' ? '_' : '-';
  }
  constexpr size_t kLongest = 60;
  is_ambiguous = is_ambiguous || out.size() > kLongest;
  if (!is_ambiguous) return out;
  constexpr size_t kHashDigits = 12;
  const size_t begin = out.size() - std::min(out.size(), kLongest - kHashDigits);
  return fmt::format("{}-{}", hash_name(text).substr(0, kHashDigits), out.substr(begin));
}

/// With dashes for spaces; a text with dashes of its own stays different.
std::string dashed(std::string text) {
  std::ranges::replace(text, '-', '/');
  std::ranges::replace(text, ' ', '-');
  return text;
}

}  // namespace

bool is_failure(Outcome outcome) {
  return is_false_negative(outcome) || outcome == Outcome::kFalsePositive ||
         outcome == Outcome::kError;
}

Failure failure_of(const Case& value, const std::string& method, const Expected& expected) {
  const auto& [outcome, cause] = expected;
  if (outcome == Outcome::kError) return {method, outcome, "", cause, Setting::kOrdinary};
  return {method, outcome, value.origin.contact, cause, setting_of(value)};
}

std::vector<Failure> failures_of(const Case& value) {
  std::vector<Failure> failures;
  for (const auto& [method, expected] : value.expect) {
    if (is_failure(expected.outcome)) failures.push_back(failure_of(value, method, expected));
  }
  return failures;
}

std::string to_text(const Failure& failure) {
  std::vector<std::string_view> details;
  for (const std::string* text : {&failure.contact, &failure.cause}) {
    if (!text->empty()) details.push_back(*text);
  }
  if (failure.setting != Setting::kOrdinary) details.push_back(name_of(failure.setting));
  return details.empty() ? fmt::format("{} by {}", name_of(failure.outcome), failure.who)
                         : fmt::format("{} by {} ({})", name_of(failure.outcome), failure.who,
                                       fmt::join(details, ", "));
}

std::string file_stem(const Failure& failure) {
  std::string stem = fmt::format("{}-{}", plain(failure.who), name_of(failure.outcome));
  for (const std::string* text : {&failure.contact, &failure.cause}) {
    if (!text->empty()) stem += "-" + plain(dashed(*text));
  }
  if (failure.setting != Setting::kOrdinary) {
    stem += "-" + dashed(std::string(name_of(failure.setting)));
  }
  return stem;
}

}  // namespace ccdfuzz
