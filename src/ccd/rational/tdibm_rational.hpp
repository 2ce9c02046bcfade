#pragma once

#include <memory>

#include "case/answer.hpp"
#include "case/query.hpp"
#include "ccd/search.hpp"

namespace ccdfuzz {

namespace exact_ccd {
class PairTest;
struct TierCounts;
}  // namespace exact_ccd

/// TDIBM (Section 3) decided in exact arithmetic: the subdivision and convergence width of the
/// double methods, with every inequality decided by its exact sign. Axes are rounded to few-bit
/// integers, as any vector is a valid axis. Ends of windows are rounded outward to a dyadic grid.
/// So numbers stay short and the search ends. Surfaces have the paper's fifteen axes; curves,
/// points and degenerate cells have more, which separate more (DERIVATION.md, 1). At a separation
/// all have those of tdibm-c (DERIVATION.md, 3).
///
/// Guarantee: a miss has no contact in the closed [0, t_max]; a hit's toi is no later than the
/// first contact. No false negative of either kind, for any valid query. A hit may be early or
/// false, as with any inclusion test, by the size of the last cells. Any bits may be asked about:
/// what is no valid query (is_taken) is refused.
/// Keeps its buffers between queries, at most kKeptBytes, and no other state. One thread at a time.
class TdibmRational {
 public:
  TdibmRational();
  ~TdibmRational();
  TdibmRational(TdibmRational&&) noexcept;
  TdibmRational& operator=(TdibmRational&&) noexcept;

  Answer answer(const Query& query, const SearchOptions& options);

  /// How often each arithmetic tier decided, over the life of the object.
  const exact_ccd::TierCounts& tiers() const;

 private:
  std::unique_ptr<exact_ccd::PairTest> test_;
  Search<exact_ccd::PairTest> search_;
};

}  // namespace ccdfuzz
