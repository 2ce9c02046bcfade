#pragma once

#include "case/checked_case.hpp"
#include "case/judge.hpp"

namespace ccdfuzz {

/// How an answer stands by these terms (judge). Under a tolerance in space a miss or a late hit of
/// bodies is correct where they overlap no deeper in the time that it overlooks. It is unknown
/// where that is not measured. Whether a contact comes within the early tolerance after a hit is
/// decided where that is exact. is_ordinary: who is asked ordinary queries alone may overlook a
/// contact of a mesh, or one at the start, that has no depth.
Outcome outcome_of(const CheckedCase& known, const Answer& answer, const AnswerTerms& terms,
                   bool is_ordinary);

}  // namespace ccdfuzz
