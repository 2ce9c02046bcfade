#pragma once

#include "ccd/rational/gap.hpp"
#include "ccd_rational/exact_reference.hpp"
#include "ccd_rational/random_query.hpp"

namespace ccdfuzz::exact_ccd {

inline constexpr int kMostAxisBits = 30;

inline IntegerAxis any_axis(int bits) {
  const std::int32_t most = std::int32_t{1} << bits;
  if (*rc::gen::inRange(0, 3) == 0) return {{0, *rc::gen::element(1, -1, most), 0}};
  IntegerAxis axis;
  for (std::int32_t& x : axis.l) x = *rc::gen::inRange(-most, most + 1);
  RC_PRE(axis.norm1() > 0);
  return axis;
}

/// A time that may be the end of a window: 0, t_max, or a multiple of 2^grid.
inline double any_window_end(const Query& query, const Units& units) {
  switch (*rc::gen::inRange(0, 3)) {
    case 0:
      return 0;
    case 1:
      return query.t_max;
    default: {
      const double steps = std::floor(std::ldexp(query.t_max, -units.grid));
      const auto k = static_cast<double>(*rc::gen::inRange(0, static_cast<int>(steps) + 1));
      return std::ldexp(k, units.grid);
    }
  }
}

/// A pair of cells of a query, and an axis.
struct Setting {
  Query query;
  std::array<CellFamily, 2> families;
  IntegerAxis axis;

  std::vector<ExactLine> lines(size_t side) const {
    return exact_lines(query.patches[side], families[side].cell(), axis);
  }
  void put(Gap& gap) const {
    gap.begin(query);
    for (int side = 0; side < 2; ++side) {
      gap.prepare(side, families[static_cast<size_t>(side)].all());
    }
    gap.select(families[0].chosen, families[1].chosen);
    gap.project(axis, kMostAxisBits);
  }
};

inline Setting any_setting(int max_degree, int max_depth) {
  Setting s;
  s.query = any_query(max_degree);
  const int depth = *rc::gen::inRange(0, max_depth + 1);
  for (size_t side = 0; side < 2; ++side) {
    s.families[side] = any_family(s.query.patches[side].shape, depth);
  }
  s.axis = any_axis(*rc::gen::inRange(0, kMostAxisBits + 1));
  return s;
}

}  // namespace ccdfuzz::exact_ccd
