#pragma once

#include "case/judge.hpp"
#include "method/method_set.hpp"

namespace ccdfuzz {

struct NamedCase;

/// Gives a case that says nothing of its truth what is decided exactly, with certificates (decide).
/// This is for linear queries, as those of CSVs are but the curved ones, and for bodies. Every
/// other case stays as it is.
void decide_unknown(NamedCase& named);
/// The same, and then as check_case.
Result<CheckedCase> decided_and_checked(NamedCase& named);

/// Puts the query of a case to a method and judges the answer by its terms. A method that throws
/// has the outcome error, with what it threw as the note, and undecided as the verdict. Errors:
/// throws NoProcess where it does.
Judged ask(Method& method, const CheckedCase& known, const SearchOptions& options);

/// How deep two bodies, or linear patches, pass through each other, at least, in the time that a
/// missed or late answer overlooks. Nothing where that is not measured (depth_until,
/// feature_depth), and for other queries and outcomes.
std::optional<double> depth_of(const CheckedCase& known, const Judged& judged);

}  // namespace ccdfuzz
