#pragma once

#include "eval/by_spec.hpp"
#include "query/case.hpp"

namespace ccdfuzz {

/// An answer and how it stands against its truth.
struct Judged {
  Answer answer;
  Outcome outcome = Outcome::kUnknown;
};

/// Puts the query of a case to a method and judges the answer. A method that throws has the outcome
/// error, with what it threw as the note, and undecided as the verdict.
Judged ask(Method& method, const Case& known, const SearchOptions& options);

}  // namespace ccdfuzz
