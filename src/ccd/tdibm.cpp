#include "ccd/tdibm.hpp"

#include <cmath>

#include "ccd/separation.hpp"

namespace ccdfuzz {

namespace {

double largest_component(const Points<double>& points) {
  double largest = 0;
  for (const Vec3<double>& p : points) {
    for (int k = 0; k < 3; ++k) largest = std::max(largest, std::abs(p[k]));
  }
  return largest;
}

/// (B_cp / P, k_cp) of Appendix A (b), as Appendix A (d) uses them: 2^n and 6n, with 3(n+m) for
/// the 6n of a tensor patch whose degrees differ, and 3n for a curve.
struct Growth {
  double factor;
  int roundings;
};

Growth growth_of(const Shape& shape) {
  switch (shape.kind) {
    case ShapeKind::kPoint:
      return {1, 0};
    case ShapeKind::kCurve:
      return {std::ldexp(1.0, shape.n), 3 * shape.n};
    case ShapeKind::kTriangle:
      return {std::ldexp(1.0, shape.n), 6 * shape.n};
    case ShapeKind::kTensor:
      return {std::ldexp(1.0, std::max(shape.n, shape.m)), 3 * (shape.n + shape.m)};
  }
  return {};
}

/// eps of Appendix A (d), 3·2^n·B_l·P·[(1+eps)^(k_cp + k_l + 3) − 1], per unit of P.
double projection_error(const Shape& shape, const Axis& axis) {
  const Growth growth = growth_of(shape);
  const double magnitude = 3 * growth.factor * std::ldexp(1.0, axis.stage);
  return ErrorBoundIntended::bound(magnitude, growth.roundings + 2 * axis.stage + 3);
}

}  // namespace

template <class Policy>
void TdibmInclusion<Policy>::begin(const Query& query) {
  parts_.begin(query);
  for (int side = 0; side < 2; ++side) {
    const MovingPatch<double>& patch = query.patches[side];
    extents_[side] = {largest_component(patch.positions), largest_component(patch.velocities)};
  }
}

template <class Policy>
void TdibmInclusion<Policy>::project(const ControlNet& net, const Axis& axis, const Extent& extent,
                                     double t_hi, Projection& out) const {
  out.upper.clear();
  for (size_t i = 0; i < net.positions.size(); ++i) {
    out.upper.push_back(
        {dot(axis.direction, net.velocities[i]), dot(axis.direction, net.positions[i])});
  }
  sort_lines(out.upper);
  negate_lines(out.upper, out.lower);
  if constexpr (Policy::kBoundsErrors) {
    const double error = projection_error(net.shape, axis);
    out.error =
        policy_.envelope_error(out.upper, {error * extent.velocity, error * extent.position}, t_hi);
  }
  for (Lines<double>* lines : {&out.upper, &out.lower}) {
    for (int i = 0; i < lines->size(); ++i) {
      (*lines)[i].intercept = policy_.pulled((*lines)[i].intercept);
    }
  }
}

template <class Policy>
std::optional<Window> TdibmInclusion<Policy>::test(int part_a, int part_b, const Window& window) {
  const std::array<ControlNet, 2> nets = {parts_.net(0, part_a), parts_.net(1, part_b)};
  std::array<Separation<double>, 2 * ObbAxes::kCount> separations;
  size_t count = 0;
  const ObbAxes axes = parts_.axes(part_a, part_b, window.lo);
  for (int r = 0; r < ObbAxes::kCount; ++r) {
    const Axis axis = axes[r];
    if (axis.is_zero()) continue;
    for (int side = 0; side < 2; ++side) {
      project(nets[side], axis, extents_[side], window.hi, projections_[side]);
    }
    for (int below = 0; below < 2; ++below) {  // which patch is below the other
      const Projection &f = projections_[below], &g = projections_[1 - below];
      upper_envelope(policy_, f.upper, window, envelopes_[0]);
      upper_envelope(policy_, g.lower, window, envelopes_[1]);
      policy_.raise(envelopes_[0], f.error);
      policy_.raise(envelopes_[1], g.error);
      const auto found = separation(policy_, envelopes_[0], envelopes_[1], window);
      if (!found) continue;
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
