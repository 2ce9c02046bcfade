#pragma once

#include <algorithm>
#include <type_traits>
#include <vector>

#include "bezier/exact_patch.hpp"
#include "bezier/restrict.hpp"
#include "case/query.hpp"
#include "ccd/rational/gap.hpp"
#include "generators/draw_patch.hpp"
#include "properties/exact_lines.hpp"
#include "properties/show.hpp"

// What tdibm-rational is compared with: slow, and as close to the definitions as can be.
namespace ccdfuzz {

/// The control points of a cell, projected on an axis: the cell's own, restricted exactly. S: of
/// rational patches Rational, else the faster Dyadic, too.
template <class S>
RationalLines lines_in(const MovingPatch<double>& patch, const Cell& cell,
                       const exact_ccd::IntegerAxis& axis) {
  const MovingPatch<S> part =
      restrict_to<S>(exact_patch<S>(patch), exact_corners<S>(cell.corners(patch.shape)));
  const auto along = [&](const Vec3<S>& p) -> Rational {
    S sum;
    for (int k = 0; k < 3; ++k) sum += p[k] * S(axis.l[static_cast<std::size_t>(k)]);
    if constexpr (std::is_same_v<S, Dyadic>) {
      return sum.rational();
    } else {
      return sum;
    }
  };
  RationalLines lines;
  for (std::size_t i = 0; i < part.positions.size(); ++i) {
    lines.push_back({along(part.velocities[i]), along(part.positions[i])});
  }
  return lines;
}
inline RationalLines lines_of_cell(const MovingPatch<double>& patch, const Cell& cell,
                                   const exact_ccd::IntegerAxis& axis) {
  return patch.is_rational() ? lines_in<Rational>(patch, cell, axis)
                             : lines_in<Dyadic>(patch, cell, axis);
}

/// max of lower − min of upper at t.
inline Rational exact_gap(const RationalLines& lower, const RationalLines& upper,
                          const Rational& t) {
  Rational max = lower[0].at(t), min = upper[0].at(t);
  for (const Line<Rational>& line : lower) max = std::max(max, line.at(t));
  for (const Line<Rational>& line : upper) min = std::min(min, line.at(t));
  return max - min;
}

/// A pair of cells of a query, of one depth, and an axis.
struct GapSetting {
  static constexpr int kMostAxisBits = 30;

  Query query;
  std::array<std::vector<Cell>, 2> parts;  ///< all children of a cell, or the root alone
  std::array<int, 2> chosen{};
  exact_ccd::IntegerAxis axis;

  RationalLines lines(std::size_t side) const {
    const Cell& cell = parts[side][static_cast<std::size_t>(chosen[side])];
    return lines_of_cell(query.patches[side], cell, axis);
  }
  /// The gap at t if side 0 is below, and if side 1 is.
  std::array<Rational, 2> gaps(const Rational& t) const {
    const RationalLines a = lines(0), b = lines(1);
    return {exact_gap(a, b, t), exact_gap(b, a, t)};
  }
  void put(exact_ccd::Gap& gap) const {
    gap.begin(query);
    for (int side = 0; side < 2; ++side) gap.prepare(side, parts[static_cast<std::size_t>(side)]);
    gap.select(chosen[0], chosen[1]);
    gap.project(axis);
  }
};

inline GapSetting draw_gap_setting(Draw& d, const Query& query, int max_depth) {
  GapSetting s;
  s.query = query;
  const std::int64_t depth = show(d, "depth", d.integer(0, max_depth));
  for (std::size_t side = 0; side < 2; ++side) {
    const Shape& shape = query.patches[side].shape;
    const Cell parent = draw_cell_at(d, shape, depth - 1);
    for (int c = 0; c < (depth == 0 ? 1 : shape.child_count()); ++c) {
      s.parts[side].push_back(depth == 0 ? parent : parent.child(shape, c));
    }
    s.chosen[side] = static_cast<int>(d.below(s.parts[side].size()));
  }
  const std::int32_t most = std::int32_t{1} << d.integer(0, GapSetting::kMostAxisBits);
  for (std::int32_t& x : s.axis.l) x = static_cast<std::int32_t>(d.integer(-most, most));
  suppose(s.axis.norm1() > 0);
  show(d, "query", s.query);
  show(d, "chosen", s.chosen);
  show(d, "axis", s.axis.l);
  return s;
}

}  // namespace ccdfuzz
