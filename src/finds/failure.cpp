#include "finds/failure.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>

#include "base/hash_name.hpp"
#include "case/scale.hpp"

namespace ccdfuzz {

namespace {

/// Below this no sum or product of a few coordinates and times under- or overflows.
constexpr int kOrdinaryBits = 40;

bool all_equal(const Points<double>& points, const Vec3<double>& first) {
  return std::ranges::all_of(points, [&](const Vec3<double>& p) { return p == first; });
}

bool is_degenerate(const Query& query) {
  const auto& [a, b] = query.patches;
  const auto moves_by = [](const MovingPatch<double>& patch, const Vec3<double>& velocity) {
    for (size_t i = 0; i < patch.positions.size(); ++i) {
      if (rounded_velocity(patch, i) != velocity) return false;
    }
    return true;
  };
  const auto has_no_extent = [&](const MovingPatch<double>& patch) {
    return patch.positions.size() > 1 && all_equal(patch.positions, patch.positions[0]) &&
           moves_by(patch, rounded_velocity(patch, 0));
  };
  const Vec3<double> velocity = rounded_velocity(a, 0);
  return has_no_extent(a) || has_no_extent(b) || (moves_by(a, velocity) && moves_by(b, velocity));
}

bool is_at_an_end(const Case& value) {
  const std::optional<Witness>& witness = value.truth.witness;
  return witness && (witness->t == 0 || round_up(witness->t) == value.query.t_max);
}

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

/// With dashes for spaces; what had dashes is told from that.
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

std::string_view name_of(Setting setting) {
  constexpr std::array<std::string_view, 4> kNames = {"ordinary", "at an end", "degenerate",
                                                      "extreme"};
  return kNames[static_cast<size_t>(setting)];
}

Setting setting_of(const Case& value) {
  if (!is_within_scale(value.query, kOrdinaryBits)) return Setting::kExtreme;
  if (is_degenerate(value.query)) return Setting::kDegenerate;
  return is_at_an_end(value) ? Setting::kAtAnEnd : Setting::kOrdinary;
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
