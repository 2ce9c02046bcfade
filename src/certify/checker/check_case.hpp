#pragma once

#include "case/checked_case.hpp"

namespace ccdfuzz {

/// Checks that the case's clearance holds and proves all that the case says of absence. That is no
/// contact in the closed [0, t_max] if collides is false, and none in the half-open [0,
/// clear_until). Errors: what is missing or refuted, naming JSON path.
Result<void> check_absence(const Case& value);

/// Checks all that a case proves: check_truth and, if it has a certificate of absence,
/// check_absence. What it says of absence without a certificate stays unproven: it is no error, and
/// no answer is judged by it. Errors: what is refuted, naming JSON path and value.
Result<CheckedCase> check_case(Case value);

/// The same; where it is refused, nothing is known of it.
CheckedCase checked_or_unknown(const Case& value);

/// The same of what proves a contact alone; nothing is known of absence.
CheckedCase checked_contact(Case value);

}  // namespace ccdfuzz
