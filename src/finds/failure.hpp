#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "case/case.hpp"

namespace ccdfuzz {

/// True iff an expectation of this outcome is of a failure: missed, late, false_positive, error.
bool is_failure(Outcome outcome);

/// How convincing a query is that shows a failure: the last of these that applies. It is part of
/// the failure, so that shrinking cannot slide from an ordinary query into a trivial one.
enum class Setting : std::uint8_t {
  kOrdinary,
  kAtAnEnd,     ///< the contact is nearer to an end of [0, t_max] than kEndShare of it
  kTouching,    ///< linear patches that touch at t = 0 already
  kDegenerate,  ///< a patch is as good as a point or, if it is a surface, as a line, at the start
                ///< or at the contact (kThinnest); or nothing moves against the rest
  kExtreme,     ///< a number that is not 0 lies outside 2^±40
};
inline constexpr std::array kAllSettings = {Setting::kOrdinary, Setting::kAtAnEnd,
                                            Setting::kTouching, Setting::kDegenerate,
                                            Setting::kExtreme};
/// What is taken for the end of a step: a thousandth of it, which no code that steps by time tells
/// from the next step.
inline constexpr double kEndShare = 0x1p-10;
/// A surface that is narrower than this share of its length counts as a line: meshes that people
/// simulate are wider.
inline constexpr double kThinnest = 0x1p-10;
/// "ordinary", "at an end", "touching at 0", "degenerate", "extreme".
std::string_view name_of(Setting setting);
constexpr const auto& all_of(Setting) {
  return kAllSettings;
}

Setting setting_of(const Case& value);

/// How a method fails; what a store keeps one find for.
struct Failure {
  std::string who;  ///< the method's spec
  Outcome outcome = Outcome::kUnknown;
  std::string contact;  ///< the class of the contact; empty for an error
  /// An error's name ("hang"), or what lost a contact ("left root"). May be empty.
  std::string cause;
  Setting setting = Setting::kOrdinary;  ///< ordinary for an error: a crash is a crash

  auto operator<=>(const Failure&) const = default;

  static void fields(auto& archive, auto& failure) {
    archive("method", failure.who);
    archive("outcome", failure.outcome);
    archive("class", failure.contact);
    archive("cause", failure.cause);
    archive("setting", failure.setting);
  }
};

/// The failure that an expectation of a case states. Requires is_failure(expected.outcome).
Failure failure_of(const Case& value, const std::string& method, const Expected& expected);

/// The failures that a case expects, method by method.
std::vector<Failure> failures_of(const Case& value);

/// "missed by tdibm-e (VE, left root, extreme)".
std::string to_text(const Failure& failure);

/// A file name without its ending, of letters, digits and "._-" alone: the same for equal failures,
/// another for others ("tdibm-e-missed-VE-left-root-extreme").
std::string file_stem(const Failure& failure);

}  // namespace ccdfuzz
