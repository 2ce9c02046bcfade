#pragma once

#include <set>
#include <string>
#include <tuple>

#include "case/case.hpp"

namespace ccdfuzz {

/// True iff an expectation of this outcome is of a failure: missed, late, false_positive, error.
bool is_failure(Outcome outcome);

/// What tells failures apart, and what a store keeps one entry for: method, contact class, and a
/// signature: the outcome, kind and generator of the case, and the cause where the case says one.
/// Errors are told apart by method and name alone, since a crash is a crash in whatever class.
using FailureKey = std::tuple<std::string, std::string, std::string>;
FailureKey failure_key(const Case& value, const std::string& method, const Expected& expected);

/// The failures that a case expects.
std::set<FailureKey> failures_of(const Case& value);

}  // namespace ccdfuzz
