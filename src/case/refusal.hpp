#pragma once

#include "case/answer.hpp"
#include "case/query.hpp"

namespace ccdfuzz {

/// True iff every method of ours takes the question: the query is valid (validate), the precision
/// is in (0, 1], and max_seconds is not NaN. Any bits may be asked about. Allocates nothing.
bool is_taken(const Query& query, double precision, double max_seconds);

/// The answer to a question that is not taken: kRefused, with the first field that is wrong and its
/// value in the note.
Answer refusal(const Query& query, double precision, double max_seconds);

}  // namespace ccdfuzz
