#pragma once

#include "ccd/past_start.hpp"
#include "ccd/rational/pair_test.hpp"

namespace ccdfuzz {

/// TDIBM (Section 3) decided in exact arithmetic: the subdivision and convergence width of the
/// double methods, with every inequality decided by its exact sign. Axes are rounded to few-bit
/// integers, as any vector is a valid axis. Ends of windows are rounded outward to a dyadic grid.
/// So numbers stay short and the search ends. Surfaces have the paper's fifteen axes; curves,
/// points and degenerate cells have more, which separate more (DERIVATION.md, 1). At a separation
/// all have those of tdibm-c (DERIVATION.md, 3).
///
/// Guarantee: a miss has no contact in the closed [0, t_max]; a hit's toi is no later than the
/// first contact. No false negative of either kind, for any valid query. A hit may be early or
/// false, as with any inclusion test, by the size of the last cells. Its buffers are kKeptBytes at
/// most between queries.
class TdibmRational : private Search<exact_ccd::PairTest> {
 public:
  /// As of Search; a hit at the start is moved past it where past_start proves that.
  Answer answer(const Query& query, const SearchOptions& options) {
    return past_start(query, Search::answer(query, options));
  }
};

}  // namespace ccdfuzz
