#include <algorithm>
#include <cmath>

#include "ccd/separation.hpp"
#include "properties/draw_lines.hpp"
#include "properties/error_bound.hpp"
#include "properties/exact_lines.hpp"
#include "properties/show.hpp"

namespace ccdfuzz {

namespace {

/// Eq. 3 on heights p, q of control points: the spans of p and q have a common point iff max p ≤
/// min q and max q ≤ min p, as printed. Meant is ≥, as paper.steps_are_exact has it.
void check_overlap_as_printed(Draw& d) {
  std::array<std::vector<std::int64_t>, 2> heights;
  for (auto& side : heights) {
    for (std::int64_t n = d.integer(1, 4); n > 0; --n) side.push_back(d.integer(-8, 8));
  }
  const auto p = std::ranges::minmax(heights[0]), q = std::ranges::minmax(heights[1]);
  bool has_common_point = false;
  for (std::int64_t x = -8; x <= 8; ++x) {
    has_common_point = has_common_point || (p.min <= x && x <= p.max && q.min <= x && x <= q.max);
  }
  show(d, "p", heights[0]);
  show(d, "q", heights[1]);
  CLAIM((p.max <= q.min && q.max <= p.min) == has_common_point);
}

Lines<Rational> exact_sorted(const std::vector<Line<double>>& lines) {
  Lines<Rational> out;
  for (const Line<double>& line : lines) out.push_back({exact(line.slope), exact(line.intercept)});
  sort_lines(out);
  return out;
}

/// Steps II and III in exact arithmetic against all pairs of lines. There f + g < 0 holds from the
/// last root of a falling pair to the first root of a rising one. Lines of small whole numbers
/// often cross in one point, or at an end of the window.
void check_steps_are_exact(Draw& d) {
  LinePairs pairs = draw_line_pairs(d);
  const bool is_whole = d.coin();
  for (auto* lines : {&pairs.f, &pairs.g}) {
    for (Line<double>& line : *lines) {
      if (is_whole) line = {std::nearbyint(line.slope / 4), std::nearbyint(line.intercept / 4)};
    }
  }
  const TimeWindow<Rational> w{exact(pairs.window.lo), exact(pairs.window.hi)};
  const Lines<Rational> f = exact_sorted(pairs.f), g = exact_sorted(pairs.g);
  Lines<Rational> envelope_f, envelope_g;
  upper_envelope(Plain(), f, w, envelope_f);
  upper_envelope(Plain(), g, w, envelope_g);
  const auto found = separation(Plain(), envelope_f, envelope_g, w);
  RationalLines lower(f.begin(), f.end()), upper;
  for (const Line<Rational>& y : g) upper.push_back({-y.slope, -y.intercept});
  const auto expected = separated_times(lower, upper, w.lo, w.hi);
  show(d, "lines", pairs);
  CLAIM(found.has_value() == expected.has_value());
  if (!found) return;
  CLAIM(found->lo == expected->from && found->hi == expected->to);
  CLAIM(found->has_lo == expected->from_included && found->has_hi == expected->to_included);
}

/// Two lines that cross, as the operands of Eq. 10 and C.2.
struct Crossing {
  Line<double> f, g;
};

Crossing draw_crossing(Draw& choices) {
  const LinePairs pairs = draw_line_pairs(choices);
  return {pairs.f[choices.choose(pairs.f.size() - 1)], pairs.g[choices.choose(pairs.g.size() - 1)]};
}

/// C.2: |fl(l / r) − l / r| ≤ 2·|l| / |fl(r)|·[(1 + eps)² − 1].
void check_eps_tau(Draw& d) {
  const Crossing crossing = draw_crossing(d);
  const double l = crossing.f.intercept + crossing.g.intercept;
  const double r = crossing.f.slope + crossing.g.slope;
  const Line<Dyadic> f = exact_line(crossing.f), g = exact_line(crossing.g);
  const Dyadic exact_l = f.intercept + g.intercept, exact_r = f.slope + g.slope;
  suppose(r != 0);
  // Everything times |r|·|fl(r)|.
  const Dyadic rounded_r = Dyadic::exact(r);
  const Dyadic error = abs((Dyadic::exact(l / r) * exact_r - exact_l) * rounded_r);
  show(d, "f", crossing.f);
  show(d, "g", crossing.g);
  CLAIM(error <= theorem_4_1_bound(abs(exact_l * exact_r).scaled(1), 2));
}

/// Every step of Eq. 10 rounds by as much as it may. A slope just above a power of two, and an
/// intercept just below one, get a part of their last bit more, most often about half of it.
Crossing draw_rounded_crossing(Draw& d) {
  const auto part_of = [&](double bit) {
    return bit * (0.5 + std::ldexp(d.integer(-127, 127), -8));
  };
  const int bits = d.integer(9, 48);
  const double slope = 1 + std::ldexp(static_cast<double>(d.choose(255)), -bits);
  const double intercept = 2 - std::ldexp(d.integer(1, 4), -52);
  const double sign = d.coin() ? -1 : 1;
  const double more_slope = part_of(0x1p-52), more_intercept = part_of(0x1p-51);
  return {{-sign * slope, sign * intercept}, {-sign * more_slope, sign * more_intercept}};
}

/// Section 4.5: the root of one pair of exact lines, as an end of a separated interval, is moved
/// inward and clamped to the window.
void check_safe_root(Draw& d) {
  const Crossing crossing = d.choose(3) != 0 ? draw_rounded_crossing(d) : draw_crossing(d);
  const TimeWindow<double> w{0, 4};
  Lines<double> f, g;
  f.push_back(crossing.f);
  g.push_back(crossing.g);
  const Line<Dyadic> exact_f = exact_line(crossing.f), exact_g = exact_line(crossing.g);
  suppose(crossing.f.slope + crossing.g.slope != 0);
  const auto height_at = [&](double t) {
    return exact_f.at(Dyadic::exact(t)) + exact_g.at(Dyadic::exact(t));
  };
  const bool falls = (exact_f.slope + exact_g.slope).sign() < 0;
  const double end = falls ? ErrorBoundIntended().left_root(f, g, 0, 0, w)
                           : ErrorBoundIntended().right_root(f, g, 0, 0, w);
  show(d, "f", crossing.f);
  show(d, "g", crossing.g);
  show(d, "end", end);
  CLAIM(w.lo <= end);
  CLAIM(end <= w.hi);
  const bool is_clamped = falls ? end == w.hi : end == w.lo;
  CLAIM(is_clamped || height_at(end).sign() <= 0);
}

/// C.3 as a lemma on envelopes that count as exact. The left end that the sweep finds on envelopes
/// pulled apart by I·delta is not before the exact one. Three lines against two that are almost
/// parallel to the last of them.
void check_pull_apart_path(Draw& d) {
  const LinePairs pairs{
      {{-1, .35}, {.5, -.25}, {.99, std::ldexp(d.integer(-8, 8), -54) - .495}},
      {{-1 - std::ldexp(d.integer(0, 127), -52), .5 + std::ldexp(d.integer(0, 127), -53)},
       {-1, .5}},
      {0, 1}};
  const ErrorBoundIntended policy;
  const auto [f, g] = selected_lines(policy, pairs);
  const auto found = separation(policy, f, g, pairs.window);
  suppose(found && !found->has_lo);
  const Dyadic lo = Dyadic::exact(found->lo);
  const Dyadic height = maximum(exact_lines(f), lo) + maximum(exact_lines(g), lo);
  show(d, "end", found->lo);
  show(d, "lines", pairs);
  CLAIM(height.sign() <= 0);
}

}  // namespace

std::vector<Property> intersection_claims() {
  return {
      {"paper.overlap_as_printed", "Boxes overlap on an axis iff max p <= min q and max q <= min p",
       "Eqs. 3a and 3b as printed", check_overlap_as_printed, kFails},
      {"paper.steps_are_exact",
       "In exact arithmetic, Steps II and III find just the times at which all pairs of lines are "
       "in order",
       "Section 3, Eqs. 5-10", check_steps_are_exact},
      {"paper.eps_tau", "The quotient of Eq. 10 is off by at most eps_tau", "Appendix C.2",
       check_eps_tau},
      {"tdibm-e.safe_roots",
       "An end that was moved inward and clamped is not before the root, also where all of Eq. 10 "
       "rounds by as much as it may",
       "Section 4.5, Appendices B and C.2", check_safe_root},
      {"paper.pull_apart_path",
       "Pulling envelopes apart by I delta each makes the left end that the sweep finds safe",
       "Appendix C.3, taking the envelopes as exact", check_pull_apart_path, kFails},
  };
}

}  // namespace ccdfuzz
