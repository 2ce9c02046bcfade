#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "bezier/exact_patch.hpp"
#include "bezier/restrict.hpp"
#include "case/query.hpp"
#include "ccd/line.hpp"
#include "ccd/rational/axis.hpp"
#include "generators/draw/draw.hpp"

// What tdibm-rational is compared with: slow, and as close to the definitions as can be.
namespace ccdfuzz {

using RationalLines = std::vector<Line<Rational>>;

/// The control points of a cell, projected on an axis: the cell's own, restricted exactly.
inline RationalLines lines_of_cell(const MovingPatch<double>& patch, const Cell& cell,
                                   const exact_ccd::IntegerAxis& axis) {
  const MovingPatch<Dyadic> part =
      restrict_to(exact_patch<Dyadic>(patch), exact_corners<Dyadic>(cell.corners(patch.shape)));
  const auto along = [&](const Vec3<Dyadic>& p) {
    Dyadic sum;
    for (int k = 0; k < 3; ++k) sum += p[k] * Dyadic(axis.l[static_cast<std::size_t>(k)]);
    return sum.rational();
  };
  RationalLines lines;
  for (std::size_t i = 0; i < part.positions.size(); ++i) {
    lines.push_back({along(part.velocities[i]), along(part.positions[i])});
  }
  return lines;
}

/// max of lower − min of upper at t.
inline Rational exact_gap(const RationalLines& lower, const RationalLines& upper,
                          const Rational& t) {
  Rational max = lower[0].at(t), min = upper[0].at(t);
  for (const Line<Rational>& line : lower) max = std::max(max, line.at(t));
  for (const Line<Rational>& line : upper) min = std::min(min, line.at(t));
  return max - min;
}

/// The times of [lo, hi] at which max lower < min upper: an interval from `from` to `to`, each end
/// separated or not. By all pairs of lines, without envelopes.
struct SeparatedTimes {
  Rational from, to;
  bool from_included = false, to_included = false;

  bool contains(const Rational& t) const {
    return (from < t || (from_included && from == t)) && (t < to || (to_included && to == t));
  }
};

inline std::optional<SeparatedTimes> separated_times(const RationalLines& lower,
                                                     const RationalLines& upper, const Rational& lo,
                                                     const Rational& hi) {
  SeparatedTimes s{lo, hi, true, true};
  for (const Line<Rational>& f : lower) {
    for (const Line<Rational>& g : upper) {
      const Rational slope = f.slope - g.slope, height = f.intercept - g.intercept;
      if (sgn(slope) == 0) {
        if (sgn(height) >= 0) return std::nullopt;
        continue;
      }
      const Rational root = -height / slope;  // itself not separated
      if (sgn(slope) > 0 && root <= s.to) s.to = root, s.to_included = false;
      if (sgn(slope) < 0 && root >= s.from) s.from = root, s.from_included = false;
    }
  }
  if (s.from > s.to || (s.from == s.to && !(s.from_included && s.to_included))) {
    return std::nullopt;
  }
  return s;
}

/// Any cell of this depth.
inline Cell draw_cell_at(Draw& d, const Shape& shape, std::int64_t depth) {
  Cell cell;
  const auto last = static_cast<std::uint64_t>(shape.child_count() - 1);
  for (; depth > 0; --depth) cell = cell.child(shape, static_cast<int>(d.choose(last)));
  return cell;
}

}  // namespace ccdfuzz
