#include <algorithm>
#include <cmath>
#include <limits>

#include "ccd/rational/proves_clear.hpp"
#include "ccd/rational/window.hpp"
#include "generators/draw_contact.hpp"
#include "generators/draw_patch.hpp"
#include "properties/exact_gaps.hpp"
#include "properties/show.hpp"

namespace ccdfuzz {

namespace {

using exact_ccd::Gap;

/// Numbers that are hard to bring to one magnitude, or patches that touch.
Query draw_hard_query(Draw& d, int max_degree) {
  if (d.coin()) return draw_extreme_query(d);
  return supposed(draw_contact(d, {-1000, 900, max_degree})).query;
}

/// A time that may be the end of a window: 0, t_max, or a multiple of the grid.
double draw_window_end(Draw& d, const Query& query, const exact_ccd::Units& units) {
  const std::uint64_t kind = d.choose(2);
  if (kind < 2) return kind == 0 ? 0 : query.t_max;
  const double steps = std::floor(std::ldexp(query.t_max, -units.grid));
  return std::ldexp(d.integer(0, static_cast<int>(steps)), units.grid);
}

/// As far apart as the cells are along the axis, whose gap is h < 0 there, or up to two floats off.
double draw_separation(Draw& d, const Rational& h, const Integer& norm_squared) {
  return d.nudged(round_up(-h) / std::sqrt(norm_squared.get_d()), 2);
}

void check_signs(Draw& d) {
  const bool deep = d.coin();
  GapSetting s = draw_gap_setting(d, draw_hard_query(d, deep ? kMaxDegree : 3), deep ? 40 : 14);
  Gap gap;
  s.put(gap);
  const double t = show(d, "t", draw_window_end(d, s.query, gap.units()));
  const std::array<Rational, 2> gaps = s.gaps(exact(t));
  Integer norm_squared;
  for (const std::int64_t l : s.axis.l) norm_squared += static_cast<long>(l * l);
  if (const Rational& h = std::min(gaps[0], gaps[1]); h < 0 && d.choose(3) != 3) {
    s.query.separation = draw_separation(d, h, norm_squared);
    suppose(is_valid(s.query));
    s.put(gap);
  }
  const double scaled = gap.scaled(t);
  show(d, "separation", s.query.separation);
  CLAIM(gap.unscaled(scaled) == t);
  const Rational squared = exact(s.query.separation) * exact(s.query.separation);
  const exact_ccd::Extremes extremes = gap.extremes(scaled);
  for (int below = 0; below < 2; ++below) {
    const Rational& h = gaps[static_cast<std::size_t>(below)];
    CLAIM(gap.sign(below, scaled, extremes) == (h > 0 ? 1 : sgn(squared * norm_squared - h * h)));
  }
}

/// What cut_window did to a window, beside the times up to and from which one sign of the axis
/// separates.
struct CutMade {
  TimeWindow<Rational> before, after, separated;
  bool all_separated = false;
  bool is_left = true;
  Rational step;  ///< the distance of two times of the grid
  /// The least gap at an end, by its error bound, of what is separated at one of the ends alone.
  double least_gap = std::numeric_limits<double>::infinity();
};

CutMade make_cut(Draw& d, const GapSetting& s) {
  Gap gap;
  s.put(gap);
  const double a = draw_window_end(d, s.query, gap.units());
  const double b = draw_window_end(d, s.query, gap.units());
  Window window{gap.scaled(std::min(a, b)), gap.scaled(std::max(a, b))};
  const std::array ends = {window.lo, window.hi};
  const auto unscaled = [&] {
    return TimeWindow<Rational>{exact(gap.unscaled(window.lo)), exact(gap.unscaled(window.hi))};
  };
  CutMade made;
  made.before = made.separated = unscaled();
  made.is_left = cut_window(gap, window);
  made.after = unscaled();
  made.step = power_of_two(gap.units().grid);
  const auto& [lo, hi] = made.before;
  for (std::size_t below = 0; below < 2; ++below) {
    const auto times = separated_times(s.lines(below), s.lines(1 - below), lo, hi);
    if (!times) continue;
    const bool from_lo = times->contains(lo), to_hi = times->contains(hi);
    made.all_separated = made.all_separated || (from_lo && to_hi);
    if (from_lo != to_hi) {
      for (const double t : ends) {
        const double at_end = std::abs(gap.extremes(t).gap(static_cast<int>(below)));
        made.least_gap = std::min(made.least_gap, at_end / gap.error());
      }
    }
    if (from_lo) made.separated.lo = std::max(made.separated.lo, times->to);
    if (to_hi) made.separated.hi = std::min(made.separated.hi, times->from);
  }
  show(d, "window", std::array{lo, hi});
  show(d, "cut to", std::array{made.after.lo, made.after.hi});
  show(d, "separated up to, and from", std::array{made.separated.lo, made.separated.hi});
  show(d, "a window is left", made.is_left);
  return made;
}

/// Laws R1, R2 and R3. An exact root stays.
void check_cuts(Draw& d) {
  const bool is_plain = d.coin();
  Query query = is_plain ? supposed(draw_contact(d, {0, 0, 3})).query : draw_hard_query(d, 3);
  if (is_plain) query.t_max = d.pick(std::array{1.0, 2.0, 0.1, 1 + 0x1p-30, 3.0});
  const auto [before, after, separated, all_separated, is_left, step, least_gap] =
      make_cut(d, draw_gap_setting(d, query, 6));
  CLAIM(is_left != all_separated);
  if (all_separated) return;
  CLAIM(before.lo <= after.lo && after.lo <= separated.lo);
  CLAIM(separated.hi <= after.hi && after.hi <= before.hi);
  CLAIM(after.lo <= after.hi);
  // Newton's iteration in doubles stops at a gap of the error bound. As the gap is convex, that is
  // within this part of the window of the root: less than a step.
  if (!is_plain || least_gap <= 0x1p32) return;
  CLAIM(separated.lo - after.lo <= 2 * step);
  CLAIM(after.hi - separated.hi <= 2 * step);
}

}  // namespace

std::vector<Property> rational_windows_claims() {
  return {
      {"tdibm-rational.signs",
       "The sign of a gap at an end of a window is the exact one, also at a separation",
       "src/ccd/rational/gap.hpp", check_signs},
      {"tdibm-rational.cuts",
       "A window loses times at which an axis separates, from its ends, and all of them at once; "
       "all but two steps of them, where doubles tell the gaps at its ends well",
       "src/ccd/rational/window.hpp", check_cuts},
      {"tdibm-rational.proves_no_contact_away", "No proof of absence covers the time of a contact",
       "src/ccd/rational/proves_clear.hpp",
       [](Draw& d) {
         const Case known = show(d, "contact", supposed(draw_contact(d, {-900, 900, 2})));
         CLAIM(!proves_clear(known.query, known.truth.witness->t, {.pops = 1000}));
       }},
  };
}

}  // namespace ccdfuzz
