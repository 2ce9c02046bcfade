#include "ccd/tdibm.hpp"

#include "ccd/separation.hpp"

namespace ccdfuzz {

template <class Policy>
void TdibmInclusion<Policy>::begin(const Query& query) {
  parts_.begin(query);
  for (int side = 0; side < 2; ++side) extents_[side] = extent_of(query.patches[side]);
}

template <class Policy>
void TdibmInclusion<Policy>::project_side(int side, const ControlNet& net, const Axis& axis,
                                          double t_hi) {
  Projection& out = projections_[side];
  project(net, axis, out.upper);
  negate_lines(out.upper, out.lower);
  if constexpr (Policy::kBoundsErrors) {
    const CoefficientError error = coefficient_error(net.shape, extents_[side], axis);
    out.error = policy_.envelope_error(out.upper, error, t_hi);
  }
  for (Lines<double>* lines : {&out.upper, &out.lower}) {
    for (int i = 0; i < lines->size(); ++i) {
      (*lines)[i].intercept = policy_.pulled((*lines)[i].intercept);
    }
  }
}

template <class Policy>
std::optional<Window> TdibmInclusion<Policy>::test(int part_a, int part_b, const Window& window) {
  Unobserved nobody;
  return test_for(nobody, part_a, part_b, window);
}

template <class Policy>
std::optional<Window> TdibmInclusion<Policy>::test(int part_a, int part_b, const Window& window,
                                                   ExclusionObserver& observer) {
  return test_for(observer, part_a, part_b, window);
}

template <class Policy>
template <class Observer>
std::optional<Window> TdibmInclusion<Policy>::test_for([[maybe_unused]] Observer& observer,
                                                       int part_a, int part_b,
                                                       const Window& window) {
  const std::array<ControlNet, 2> nets = {parts_.net(0, part_a), parts_.net(1, part_b)};
  std::array<Separation<double>, 2 * ObbAxes::kCount> separations;
  size_t count = 0;
  const ObbAxes axes = parts_.axes(part_a, part_b, window.lo);
  for (int r = 0; r < ObbAxes::kCount; ++r) {
    const Axis axis = axes[r];
    if (axis.is_zero()) continue;
    for (int side = 0; side < 2; ++side) project_side(side, nets[side], axis, window.hi);
    for (int below = 0; below < 2; ++below) {  // which patch is below the other
      const Projection &f = projections_[below], &g = projections_[1 - below];
      upper_envelope(policy_, f.upper, window, envelopes_[0]);
      upper_envelope(policy_, g.lower, window, envelopes_[1]);
      policy_.raise(envelopes_[0], f.error);
      policy_.raise(envelopes_[1], g.error);
      const auto found = separation(policy_, envelopes_[0], envelopes_[1], window);
      if (!found) continue;
      if constexpr (Observer::kListens) observer.excluded({r, axis.direction, below, *found});
      if (found->has_lo && found->has_hi) return std::nullopt;
      separations[count++] = *found;
    }
  }
  return remaining_window<double>({separations.data(), count}, window);
}

template <class Policy>
Answer Tdibm<Policy>::answer(const Query& query, const SearchOptions& options) {
  return search_.run(query, options, inclusion_);
}

template class TdibmInclusion<Plain>;
template class TdibmInclusion<PullApart>;
template class TdibmInclusion<RelativePullApart>;
template class TdibmInclusion<ErrorBoundIntended>;
template class TdibmInclusion<ErrorBoundPrinted>;
template class Tdibm<Plain>;
template class Tdibm<PullApart>;
template class Tdibm<RelativePullApart>;
template class Tdibm<ErrorBoundIntended>;
template class Tdibm<ErrorBoundPrinted>;

}  // namespace ccdfuzz
