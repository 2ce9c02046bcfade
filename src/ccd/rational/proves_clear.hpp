#pragma once

#include "case/query.hpp"
#include "numeric/rational.hpp"

namespace ccdfuzz {

/// Proves in exact arithmetic that the patches do not touch at any time of the closed [0, until].
/// until: dyadic or not, ≥ 0; query.t_max plays no part. Returns true iff proven: false means that
/// there is a contact, that the search reached its finest cells (2^-30) or its budget first, or
/// that the query is not valid. Safe: never true if there is a contact. pops, if given, gets the
/// number of pairs of cells that it looked at. Keeps at most kKeptBytes for each thread that asked.
bool proves_clear(const Query& query, const Rational& until, std::uint64_t max_pops = 100'000,
                  std::uint64_t* pops = nullptr);

}  // namespace ccdfuzz
