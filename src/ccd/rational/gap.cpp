#include "ccd/rational/gap.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "ccd/projection.hpp"

namespace ccdfuzz::exact_ccd {

namespace {

/// (point − origin)·2^shift for all points, each operation rounded once.
void normalise(const Points<double>& points, const Vec3<double>& origin, int shift,
               Points<double>& out) {
  out.resize(points.size());
  for (size_t i = 0; i < points.size(); ++i) {
    for (int k = 0; k < 3; ++k) {
      out[i][k] = std::ldexp(points[i][k], shift) - std::ldexp(origin[k], shift);
    }
  }
}

}  // namespace

// The error bound. u = 2^-53, eta = 2^-1074, gamma_k = k·u/(1 − k·u). Times are in [0, 1]. M is the
// largest magnitude of a normalised coordinate of position plus that of velocity.
//  1. Normalised coordinates. Scaling is exact or, where it underflows, off by ≤ eta/2. The
//     difference rounds once: u·M + eta. Ends e have that error as p has, and e − p rounds once
//     more: at t ≤ 1 this adds 2u·M.
//  2. Sub-patch. Each blossom step is a combination with exact non-negative weights of sum 1. For a
//     triangle it is of three products summed from the left (gamma_3), else of two (gamma_2). Each
//     average rounds once; halving is exact unless it underflows. gamma_K in all, with K =
//     CellPointsCache::roundings ≤ 101: of a rational tensor of degree 8 with ends. Products and
//     halves may underflow, ≤ eta/2 each: with s ≤ 16 steps ≤ (1.5 + 0.5)·s·eta.
//  3. Projection, three products summed: gamma_3·|l|_1·M + 1.5·eta.
//  4. Line at t: gamma_2 + eta/2.
//  5. The difference of two extremes, each of magnitude ≤ |l|_1·M·(1 + gamma): u of each.
// Both extremes together: 2·gamma_{K+7}·|l|_1·M, plus underflow of at most 2·|l|_1·2·(1 + 2·16) eta
// + 2·(2·1.5 + 0.5) eta < 140·|l|_1·eta (steps 1 and 2 for positions and velocities; |l|_1 ≥ 1). K
// + 8 in place of gamma's K + 7 exceeds it by the factor 1 + 1/108. That covers 1/(1 − 108u) and
// the three roundings of the bound itself. Where 2·(K+8)·u·M would itself underflow, it is less
// than eta, and 256 eta in place of 140 eta covers it. A rational patch has weights of [2^-60, 2),
// and K is that of numerator and weight and 2 more. The product w·p rounds once. All weights are
// positive, so gamma_K of the new weight is relative. The quotient rounds once. What underflows is
// divided by a weight: 2^60 times as much.
void Gap::begin(const Query& query) {
  query_ = &query;
  units_ = Units::of(query);
  is_loaded_ = false;
  work_before_ = scene_.work();

  length_shift_ = -units_.top;
  const auto& [a, b] = query.patches;
  const Vec3<double> origin = a.positions[0];
  // What is to be subtracted from velocities, and from ends before their positions are: the same
  // motion. Where one patch has ends and the other velocities, it is none.
  const Vec3<double> drift = a.has_ends() || b.has_ends() ? Vec3<double>(0, 0, 0) : a.velocities[0];
  const Vec3<double> end_of_drift = a.has_ends() && b.has_ends() ? a.ends[0] : origin;
  double m_position = 0, m_velocity = 0;
  int roundings = 0;
  for (size_t side = 0; side < 2; ++side) {
    const MovingPatch<double>& patch = query.patches[side];
    normalise(patch.positions, origin, length_shift_, positions_);
    const int shift = length_shift_ + units_.horizon;
    if (patch.has_ends()) {
      normalise(patch.ends, end_of_drift, shift, velocities_);
      normalise(patch.positions, origin, shift, starts_);
      for (size_t i = 0; i < starts_.size(); ++i) velocities_[i] -= starts_[i];
    } else {
      normalise(patch.velocities, drift, shift, velocities_);
    }
    m_position = std::max(m_position, largest_component(positions_));
    m_velocity = std::max(m_velocity, largest_component(velocities_));
    roundings = std::max(roundings, CellPointsCache::roundings(patch.shape, patch.is_rational()));
    cache_[side].begin(patch.shape, positions_, velocities_, scaled_weights(patch));
  }
  if (has_ends(query)) roundings += 2;
  if (query.separation > 0) ++roundings;  // of the sum with it
  separation_ = std::ldexp(query.separation, length_shift_);
  constexpr double u = std::numeric_limits<double>::epsilon() / 2;
  constexpr double eta = std::numeric_limits<double>::denorm_min();
  const double absolute = is_rational(query) ? std::ldexp(256 * eta, kWeightBits) : 256 * eta;
  error_per_norm_ = 2 * (roundings + 8) * u * (m_position + m_velocity) + absolute;
}

void Gap::prepare(int side, std::span<const Cell> parts) {
  const auto s = static_cast<size_t>(side);
  std::copy(parts.begin(), parts.end(), parts_[s].begin());
  families_[s] = cache_[s].family(parts);
}

void Gap::select(int part_a, int part_b) {
  cells_ = {parts_[0][static_cast<size_t>(part_a)], parts_[1][static_cast<size_t>(part_b)]};
  selected_ = {points(0, part_a), points(1, part_b)};
}

void Gap::project(const IntegerAxis& axis) {
  axis_ = axis;
  error_ = error_per_norm_ * static_cast<double>(axis.norm1());
  on_axis_ = 0;
  if (separation_ > 0) {
    std::int64_t squared = 0;
    for (const std::int64_t l : axis.l) squared += l * l;
    // Four roundings at most, a fifth of the sum with the gap; an underflow of separation_ is below
    // eta, and |l|_2 ≤ |l|_1.
    on_axis_ = separation_ * std::sqrt(static_cast<double>(squared));
    error_ += 6 * (std::numeric_limits<double>::epsilon() / 2) * on_axis_;
  }
  const double x = axis.l[0], y = axis.l[1], z = axis.l[2];
  for (size_t side = 0; side < 2; ++side) {
    const CellPoints& p = selected_[side];
    const auto dots = [&](const double* px, const double* py, const double* pz, double* out) {
      for (int i = 0; i < p.count; ++i) out[i] = (x * px[i] + y * py[i]) + z * pz[i];
    };
    dots(p.position(0), p.position(1), p.position(2), intercepts_[side].data());
    dots(p.velocity(0), p.velocity(1), p.velocity(2), slopes_[side].data());
  }
}

Extremes Gap::extremes(double t) const {
  Extremes e;
  e.separation = on_axis_;
  for (size_t side = 0; side < 2; ++side) {
    const auto line = [&](const Values& of) {
      return Eigen::Map<const Eigen::ArrayXd>(of.data(), selected_[side].count);
    };
    const auto heights = line(slopes_[side]) * t + line(intercepts_[side]);
    e.max[side] = heights.maxCoeff();
    e.min[side] = heights.minCoeff();
  }
  return e;
}

double Gap::slope(int below, double t) const {
  const auto lower = static_cast<size_t>(below), upper = 1 - lower;
  int max = 0, min = 0;
  for (int i = 1; i < selected_[lower].count; ++i) {
    if (height(lower, i, t) > height(lower, max, t)) max = i;
  }
  for (int i = 1; i < selected_[upper].count; ++i) {
    if (height(upper, i, t) < height(upper, min, t)) min = i;
  }
  return slopes_[lower][static_cast<size_t>(max)] - slopes_[upper][static_cast<size_t>(min)];
}

int Gap::exact_sign(int below, double t, const Extremes& at) {
  // A control point whose projection lies more than error_ inside the extreme does not attain it:
  // each projection is off by less than error_ / 2.
  std::array<std::array<std::uint8_t, kMaxControls>, 2> marks;
  for (size_t side = 0; side < 2; ++side) {
    const bool maximum = static_cast<int>(side) == below;
    for (int i = 0; i < selected_[side].count; ++i) {
      const double value = height(side, i, t);
      const double behind = maximum ? at.max[side] - value : value - at.min[side];
      marks[side][static_cast<size_t>(i)] = behind <= 2 * error_ ? 1 : 0;
    }
  }
  const std::array<std::span<const std::uint8_t>, 2> candidates = {
      std::span(marks[0]).first(static_cast<size_t>(selected_[0].count)),
      std::span(marks[1]).first(static_cast<size_t>(selected_[1].count))};
  if (!std::exchange(is_loaded_, true)) scene_.load(*query_, units_);
  return scene_.gap_sign(below, cells_, axis_, unscaled(t), candidates);
}

}  // namespace ccdfuzz::exact_ccd
