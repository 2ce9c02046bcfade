#pragma once

#include <set>
#include <string>
#include <tuple>

#include "case/case.hpp"

namespace ccdfuzz {

/// True iff an expectation of this outcome is of a failure: missed, late, false_positive, error.
bool is_failure(Outcome outcome);

/// What tells failures apart, and what a store keeps one entry for: method, contact class, and a
/// signature: the outcome, kind and generator of the case, and how the contact was lost where the
/// case says so (set_loss). Errors are told apart by method and
/// name alone, since a crash is a crash in whatever class.
using FailureKey = std::tuple<std::string, std::string, std::string>;
FailureKey failure_key(const Case& value, const std::string& method, Outcome outcome);

/// The failures that a case expects.
std::set<FailureKey> failures_of(const Case& value);

/// The name of the error that the case expects of a method ("hang"); "" if it says none. It is
/// kept among the further keys of the origin.
std::string error_name(const Case& value, const std::string& method);
void set_error_name(Case& value, const std::string& method, const std::string& name);

/// How the method loses the contact (loss_signature), among the further keys of the origin; "" to
/// say nothing of it.
void set_loss(Case& value, const std::string& method, const std::string& loss);

}  // namespace ccdfuzz
