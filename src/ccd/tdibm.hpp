#pragma once

#include <array>
#include <optional>
#include <span>

#include "ccd/exclusion.hpp"
#include "ccd/projection.hpp"
#include "ccd/search.hpp"
#include "ccd/sub_patches.hpp"

namespace ccdfuzz {

/// The time-dependent inclusion test of the paper (Section 3, Steps I–III) under a robustness
/// policy: two sub-patches may touch where no OBB axis separates their control points.
/// Claim, by Policy: test never drops a time at which the two parts touch.
template <class Policy>
class TdibmInclusion {
 public:
  explicit TdibmInclusion(Policy policy) : policy_(policy) {}

  void begin(const Query& query);
  void prepare(int side, std::span<const Cell> parts) { parts_.prepare(side, parts); }
  std::optional<Window> test(int part_a, int part_b, const Window& window);
  std::optional<Window> test(int part_a, int part_b, const Window& window,
                             ExclusionObserver& observer);

 private:
  /// The lines of one part on one axis, ready for Step II: as they are for its maximum, negated
  /// for its minimum; and eps_constr.
  struct Projection {
    Lines<double> upper, lower;
    double error = 0;
  };

  void project_side(int side, const ControlNet& net, const Axis& axis, double t_hi);
  template <class Observer>
  std::optional<Window> test_for(Observer& observer, int part_a, int part_b, const Window& window);

  Policy policy_;
  SubPatches parts_;
  std::array<Extent, 2> extents_;
  std::array<Projection, 2> projections_;
  std::array<Lines<double>, 2> envelopes_;
};

extern template class TdibmInclusion<Plain>;
extern template class TdibmInclusion<PullApart>;
extern template class TdibmInclusion<RelativePullApart>;
extern template class TdibmInclusion<ErrorBoundIntended>;
extern template class TdibmInclusion<ErrorBoundPrinted>;

/// The paper's methods: `tdibm` (Plain), `tdibm-h:F` (PullApart), `tdibm-h-rel:F`
/// (RelativePullApart), `tdibm-e` (ErrorBoundIntended), `tdibm-e-literal` (ErrorBoundPrinted).
/// One object serves one thread and keeps its buffers between queries.
template <class Policy>
class Tdibm {
 public:
  explicit Tdibm(Policy policy = Policy()) : inclusion_(policy) {}

  /// Requires a valid query (validate). toi is the start of the first window that was narrow
  /// enough; it is as safe as Policy is.
  Answer answer(const Query& query, const SearchOptions& options);

 private:
  TdibmInclusion<Policy> inclusion_;
  Search<TdibmInclusion<Policy>> search_;
};

extern template class Tdibm<Plain>;
extern template class Tdibm<PullApart>;
extern template class Tdibm<RelativePullApart>;
extern template class Tdibm<ErrorBoundIntended>;
extern template class Tdibm<ErrorBoundPrinted>;

}  // namespace ccdfuzz
