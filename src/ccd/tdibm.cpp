#include "ccd/tdibm.hpp"

#include <algorithm>
#include <numeric>

#include "ccd/separation.hpp"

namespace ccdfuzz {

template <class Policy>
void TdibmInclusion<Policy>::begin(const Query& query) {
  parts_.begin(query);
  if constexpr (Policy::kBoundsErrors) {
    for (size_t side = 0; side < 2; ++side) {
      const LargestComponents extent = largest_components_of(query.patches[side]);
      for (int stage = 0; stage < ObbAxes::kStages; ++stage) {
        stage_errors_[side][static_cast<size_t>(stage)] =
            coefficient_error(query.patches[side].shape, extent, Axis{{0, 0, 0}, stage});
      }
    }
  }
  std::iota(order_.begin(), order_.end(), 0);
}

template <class Policy>
void TdibmInclusion<Policy>::prepare(int side, std::span<const Cell> parts) {
  parts_.prepare(side, parts);
  for (auto& axes : own_[static_cast<size_t>(side)]) {
    for (OnAxis& on_axis : axes) on_axis.forget();
  }
}

template <class Policy>
void TdibmInclusion<Policy>::OnAxis::project(const Policy& policy, const ControlNet& net,
                                             const Axis& axis,
                                             std::span<const CoefficientError> stage_errors,
                                             double t_hi) {
  Lines<double>&lines = halves_[0].lines, &negated = halves_[1].lines;
  ccdfuzz::project(net, axis, lines);
  negate_lines(lines, negated);
  if constexpr (Policy::kBoundsErrors) {
    error_ = policy.envelope_error(lines, stage_errors[static_cast<size_t>(axis.stage)], t_hi);
  }
  for (Half& half : halves_) {
    for (int i = 0; i < half.lines.size(); ++i) {
      half.lines[i].intercept = policy.pulled(half.lines[i].intercept);
    }
    half.has_envelope = false;
  }
  direction_ = axis.direction;
}

template <class Policy>
const Lines<double>& TdibmInclusion<Policy>::OnAxis::envelope(size_t half, const Policy& policy,
                                                              const Window& w) {
  auto& [lines, envelope, has_envelope] = halves_[half];
  if (!has_envelope) {
    upper_envelope(policy, lines, w, envelope);
    policy.raise(envelope, error_);
    has_envelope = true;
  }
  return envelope;
}

/// Part `part` of patch `side` on axis r: one of its own three, or another.
template <class Policy>
typename TdibmInclusion<Policy>::OnAxis& TdibmInclusion<Policy>::on_axis(int side, int part, int r,
                                                                         const Axis& axis,
                                                                         const Window& window) {
  const auto s = static_cast<size_t>(side);
  const bool own = r / 3 == side;
  OnAxis& place =
      own ? own_[s][static_cast<size_t>(part)][static_cast<size_t>(r % 3)] : scratch_[s];
  // Stand-ins for zero axes depend on the other part too: an axis is known by its direction.
  if (!own || place.direction() != axis.direction) {
    place.project(policy_, parts_.net(side, part), axis, stage_errors_[s], window.hi);
  }
  return place;
}

template <class Policy>
std::optional<Window> TdibmInclusion<Policy>::test(int part_a, int part_b, const Window& window,
                                                   ExclusionObserver* observer) {
  std::array<SeparatedInterval<double>, 2 * ObbAxes::kCount> separations;
  size_t count = 0;
  if (window.lo != seen_.lo || window.hi != seen_.hi) {
    for (auto& side : own_) {
      for (auto& part : side) {
        for (OnAxis& on_axis : part) on_axis.forget();
      }
    }
    seen_ = window;
  }
  const Window wide{window.lo - reading_.window_margin, window.hi + reading_.window_margin};
  const ObbAxes axes = parts_.axes(part_a, part_b, window.lo);
  for (size_t k = 0; k < order_.size(); ++k) {
    const int r = observer != nullptr ? static_cast<int>(k) : order_[k];
    const Axis axis = axes[r];
    if (axis.is_zero()) continue;
    OnAxis* const on[2] = {&on_axis(0, part_a, r, axis, wide), &on_axis(1, part_b, r, axis, wide)};
    for (int below = 0; below < 2; ++below) {  // which patch is below the other
      auto found = separation(policy_, on[below]->envelope(0, policy_, wide),
                              on[1 - below]->envelope(1, policy_, wide), wide);
      if (found && reading_.window_margin > 0) found = clipped_to(window, *found);
      if (!found) continue;
      if (observer != nullptr) observer->excluded({r, axis.direction, below, *found});
      if (found->has_lo && found->has_hi) {
        if (observer == nullptr) {
          std::rotate(order_.begin(), order_.begin() + static_cast<std::ptrdiff_t>(k),
                      order_.begin() + static_cast<std::ptrdiff_t>(k) + 1);
        }
        return std::nullopt;
      }
      separations[count++] = *found;
    }
  }
  return remaining_window<double>({separations.data(), count}, window);
}

template class TdibmInclusion<Plain>;
template class TdibmInclusion<PullApart>;
template class TdibmInclusion<ErrorBoundIntended>;
template class TdibmInclusion<ErrorBoundPrinted>;
template class Search<TdibmInclusion<Plain>>;
template class Search<TdibmInclusion<PullApart>>;
template class Search<TdibmInclusion<ErrorBoundIntended>>;
template class Search<TdibmInclusion<ErrorBoundPrinted>>;

}  // namespace ccdfuzz
