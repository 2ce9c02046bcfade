#include "finds/failure.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <Eigen/Geometry>

#include <algorithm>
#include <cctype>
#include <cmath>

#include "base/hash_name.hpp"
#include "case/scale.hpp"
#include "certify/checker/check_linear.hpp"

namespace ccdfuzz {

namespace {

/// Below this no sum or product of a few coordinates and times under- or overflows.
constexpr int kOrdinaryBits = 40;

/// Whether the control points of a patch at time t are as good as one point or, of a surface, as
/// points of a line. Rounded: it says how convincing a query is and decides nothing.
bool is_flat(const MovingPatch<double>& patch, double t) {
  const auto at = [&](size_t i) {
    return Vec3<double>(patch.positions[i] + t * rounded_velocity(patch, i));
  };
  const Vec3<double> origin = at(0);
  Vec3<double> longest{0, 0, 0};
  for (size_t i = 1; i < patch.positions.size(); ++i) {
    const Vec3<double> side = at(i) - origin;
    if (side.squaredNorm() > longest.squaredNorm()) longest = side;
  }
  const double length2 = longest.squaredNorm();
  const int parameters = patch.shape.parameter_count();
  if (parameters < 2) return parameters == 1 && length2 == 0;
  double area2 = 0;
  for (size_t i = 1; i < patch.positions.size(); ++i) {
    area2 = std::max(area2, longest.cross(Vec3<double>(at(i) - origin)).squaredNorm());
  }
  return std::sqrt(area2) <= kThinnest * length2;
}

bool is_at_rest(const Query& query) {
  const Vec3<double> velocity = rounded_velocity(query.patches[0], 0);
  for (const MovingPatch<double>& patch : query.patches) {
    for (size_t i = 0; i < patch.positions.size(); ++i) {
      if (rounded_velocity(patch, i) != velocity) return false;
    }
  }
  return true;
}

bool is_degenerate(const Case& value) {
  const std::optional<Rational> contact = value.truth.contact_by();
  return is_at_rest(value.query) ||
         std::ranges::any_of(value.query.patches, [&](const MovingPatch<double>& patch) {
           return is_flat(patch, 0) || (contact && is_flat(patch, contact->get_d()));
         });
}

bool touches_at_start(const Query& query) {
  return query.separation == 0 && is_linear_query(query) &&
         !check_linear_clearance(query, {Rational(0), true});
}

bool is_at_an_end(const Case& value) {
  const std::optional<Rational> contact = value.truth.contact_by();
  if (!contact) return false;
  const double t = contact->get_d(), end = kEndShare * value.query.t_max;
  return t <= end || t >= value.query.t_max - end;
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
  constexpr std::array<std::string_view, 5> kNames = {"ordinary", "at an end", "touching at 0",
                                                      "degenerate", "extreme"};
  return kNames[static_cast<size_t>(setting)];
}

Setting setting_of(const Case& value) {
  if (!is_within_scale(value.query, kOrdinaryBits)) return Setting::kExtreme;
  if (is_degenerate(value)) return Setting::kDegenerate;
  if (touches_at_start(value.query)) return Setting::kTouching;
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
