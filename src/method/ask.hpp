#pragma once

#include "case/judge.hpp"
#include "method/by_spec.hpp"

namespace ccdfuzz {

/// Puts the query of a case to a method and judges the answer by its terms. A method that throws
/// has the outcome error, with what it threw as the note, and undecided as the verdict.
Judged ask(Method& method, const CheckedCase& known, const SearchOptions& options);

/// The same, checking the case first (checked_or_unknown), each time that it is asked.
Judged ask(Method& method, const Case& known, const SearchOptions& options);

}  // namespace ccdfuzz
