#pragma once

#include "case/query.hpp"
#include "case/search_options.hpp"
#include "numeric/rational.hpp"

namespace ccdfuzz {

/// What a proof takes: pairs of cells, and what SearchOptions::max_work counts.
struct ClearEffort {
  std::uint64_t pops = 100'000;
  std::uint64_t work = SearchOptions::kMostExactWork;
};

/// Proves in exact arithmetic that the patches do not touch at any time of the closed [0, until].
/// until: dyadic or not, ≥ 0; query.t_max plays no part. Returns true iff proven. False means one
/// of these: there is a contact; the search reached its finest cells (2^-30) or `most` first; the
/// query is not valid. Safe: never true if there is a contact. spent, if given, gets what it took,
/// of work up to one pair of cells more. Keeps at most kKeptBytes for each thread that asked.
bool proves_clear(const Query& query, const Rational& until, const ClearEffort& most = {},
                  ClearEffort* spent = nullptr);

}  // namespace ccdfuzz
