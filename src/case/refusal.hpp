#pragma once

#include "case/answer.hpp"
#include "case/query.hpp"
#include "case/search_options.hpp"

namespace ccdfuzz {

/// True iff it is a question: the query is valid (validate), the precision is in (0, 1], and
/// max_seconds is not NaN. Any bits may be asked about. Allocates nothing.
bool is_question(const Query& query, const SearchOptions& options);

/// True iff every method of ours takes it: it is a question, and about patches, not bodies.
bool is_taken(const Query& query, const SearchOptions& options);

inline constexpr const char* kNoBodies = "takes patches, and this query has bodies";

/// The answer to a question that is not taken: kRefused, with the first field that is wrong and its
/// value in the note.
Answer refusal(const Query& query, const SearchOptions& options);

}  // namespace ccdfuzz
