#include "ccd/unoptimised.hpp"

#include <algorithm>
#include <memory>
#include <vector>

#include "bezier/restrict.hpp"
#include "ccd/separation.hpp"
#include "numeric/products.hpp"

namespace ccdfuzz {

namespace {

/// Steps I and II for one patch in one direction: sign −1 stands for the lower envelope.
template <class Policy>
std::unique_ptr<Lines<double>> envelope(const Policy& policy, const MovingPatch<double>& part,
                                        const LargestComponents& extent, const Axis& axis,
                                        double sign, const Window& w) {
  std::vector<Line<double>> heights;
  for (size_t i = 0; i < part.positions.size(); ++i) {
    heights.push_back({sign * dot(axis.direction, part.velocities[i]),
                       sign * dot(axis.direction, part.positions[i])});
  }
  Lines<double> lines;
  // Overflow leaves NaN, which has no place in an order, and std::sort must not see.
  const bool ordered = std::ranges::none_of(heights, [](const Line<double>& line) {
    return std::isnan(line.slope) || std::isnan(line.intercept);
  });
  if (ordered) {
    std::ranges::sort(heights, [](const Line<double>& x, const Line<double>& y) {
      return x.slope < y.slope || (x.slope == y.slope && x.intercept < y.intercept);
    });
  }
  for (const Line<double>& line : heights) lines.push_back(line);
  if (!ordered) sort_lines(lines);
  double error = 0;
  if constexpr (Policy::kBoundsErrors) {
    error = policy.envelope_error(lines, coefficient_error(part.shape, extent, axis), w.hi);
  }
  for (int i = 0; i < lines.size(); ++i) lines[i].intercept = policy.pulled(lines[i].intercept);
  auto found = std::make_unique_for_overwrite<Lines<double>>();
  upper_envelope(policy, lines, w, *found);
  policy.raise(*found, error);
  return found;
}

}  // namespace

template <class Policy>
void UnoptimisedInclusion<Policy>::begin(const Query& query) {
  query_ = &query;
  for (size_t side = 0; side < 2; ++side)
    extents_[side] = largest_components_of(query.patches[side]);
}

template <class Policy>
void UnoptimisedInclusion<Policy>::prepare(int side, std::span<const Cell> parts) {
  std::ranges::copy(parts, cells_[static_cast<size_t>(side)].begin());
}

template <class Policy>
std::optional<Window> UnoptimisedInclusion<Policy>::test(int part_a, int part_b,
                                                         const Window& window) {
  const auto& patches = query_->patches;
  const std::array<MovingPatch<double>, 2> parts = {
      restrict_to(patches[0], cells_[0][static_cast<size_t>(part_a)].corners(patches[0].shape)),
      restrict_to(patches[1], cells_[1][static_cast<size_t>(part_b)].corners(patches[1].shape))};
  const auto frame = [&](int side) {
    const MovingPatch<double>& part = parts[static_cast<size_t>(side)];
    return obb_frame({part.shape, part.positions, part.velocities}, window.lo, reading_.axes, side);
  };
  const ObbAxes axes({parts[0].shape, parts[1].shape}, frame(0), frame(1), reading_.axes.length);
  const Window wide{window.lo - reading_.window_margin, window.hi + reading_.window_margin};
  std::vector<SeparatedInterval<double>> separations;
  for (int r = 0; r < ObbAxes::kCount; ++r) {
    const Axis axis = axes[r];
    if (axis.is_zero()) continue;
    for (size_t below = 0; below < 2; ++below) {
      const size_t above = 1 - below;
      const auto f = envelope(policy_, parts[below], extents_[below], axis, 1, wide);
      const auto g = envelope(policy_, parts[above], extents_[above], axis, -1, wide);
      auto found = separation(policy_, *f, *g, wide);
      if (found && reading_.window_margin > 0) found = clipped_to(window, *found);
      if (!found) continue;
      if (found->has_lo && found->has_hi) return std::nullopt;
      separations.push_back(*found);
    }
  }
  return remaining_window<double>(separations, window);
}

template class UnoptimisedInclusion<Plain>;
template class UnoptimisedInclusion<PullApart>;
template class UnoptimisedInclusion<ErrorBoundIntended>;
template class UnoptimisedInclusion<ErrorBoundPrinted>;

}  // namespace ccdfuzz
