#pragma once

#include <compare>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "case/case.hpp"
#include "method/setting.hpp"

namespace ccdfuzz {

/// True iff an expectation of this outcome is of a failure: missed, late, false_positive, error.
bool is_failure(Outcome outcome);

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
