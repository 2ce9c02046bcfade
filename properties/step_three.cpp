#include <cmath>
#include <optional>
#include <utility>

#include "ccd/separation.hpp"
#include "properties/draw_lines.hpp"
#include "properties/show.hpp"

namespace ccdfuzz {

namespace {

/// Lines a[i]·t + b[i] of the max envelope of patch 1, and of the min envelope of patch 2.
struct PaperEnvelopes {
  Lines<double> first, second;
};

/// The indices alpha, beta at which the walk of Section 3 ends. Nothing if the lines end first, or
/// the distance of the envelopes no longer grows.
template <class Policy>
std::optional<std::pair<int, int>> first_crossing(const Policy& policy,
                                                  const PaperEnvelopes& envelopes, double t_end) {
  const Lines<double>&one = envelopes.first, &two = envelopes.second;
  const auto a = [&](int i, int j) { return one[i].slope - two[j].slope; };
  const auto b = [&](int i, int j) { return one[i].intercept - two[j].intercept; };
  int alpha = 0, beta = 0;
  while (alpha < one.size() && beta < two.size() && a(alpha, beta) < 0) {
    const double slope = a(alpha, beta), intercept = b(alpha, beta);
    const auto negative = [&](bool is_last, auto&& next_slope, auto&& next_intercept) {
      if (is_last) return policy.negative(EndValue<double>{slope, intercept, t_end});
      return policy.negative(
          ProductDifference<double>{next_slope(), intercept, slope, next_intercept()});
    };
    // Eq. 9, then Eq. 8.
    const bool before_beta_turns = negative(
        beta + 1 == two.size(), [&] { return a(alpha, beta + 1); },
        [&] { return b(alpha, beta + 1); });
    const bool before_alpha_turns = negative(
        alpha + 1 == one.size(), [&] { return a(alpha + 1, beta); },
        [&] { return b(alpha + 1, beta); });
    if (before_alpha_turns && before_beta_turns) return std::pair(alpha, beta);
    if (!before_alpha_turns && (before_beta_turns || Policy::kAdvancesBoth)) ++alpha;
    if (!before_beta_turns) ++beta;
  }
  return {};
}

/// The same lines by −t, in their order there.
Lines<double> backwards(const Lines<double>& lines) {
  Lines<double> out;
  for (int i = lines.size() - 1; i >= 0; --i) out.push_back({-lines[i].slope, lines[i].intercept});
  return out;
}

Lines<double> upside_down(const Lines<double>& lines) {
  Lines<double> out;
  for (const Line<double>& line : lines) out.push_back({-line.slope, -line.intercept});
  return out;
}

/// Step III: from the left, and from the right as from the left by −t. f and g as separation() has
/// them.
template <class Policy>
std::optional<SeparatedInterval<double>> literal_separation(const Policy& policy,
                                                            const Lines<double>& f,
                                                            const Lines<double>& g,
                                                            const TimeWindow<double>& w) {
  const auto apart_at = [&](int i, int j, double t) {  // Eq. 7
    return policy.negative(
        EndValue<double>{f[i].slope + g[j].slope, f[i].intercept + g[j].intercept, t});
  };
  const int last_f = f.size() - 1, last_g = g.size() - 1;
  const PaperEnvelopes forth{f, upside_down(g)};
  // The released program compares heights at the start, and differences at the end.
  const bool apart_at_start = Policy::kBoundsErrors
                                  ? apart_at(0, 0, w.lo)
                                  : forth.first[0].at(w.lo) < forth.second[0].at(w.lo);
  SeparatedInterval<double> found{w.lo, w.hi, apart_at_start, apart_at(last_f, last_g, w.hi)};
  if (!found.has_lo) {
    const auto pair = first_crossing(policy, forth, w.hi);
    if (!pair) return {};
    found.lo = policy.left_root(f, g, pair->first, pair->second, w);
  }
  if (!found.has_hi) {
    const PaperEnvelopes back{backwards(forth.first), backwards(forth.second)};
    const auto pair = first_crossing(policy, back, -w.lo);
    if (!pair) return {};
    found.hi = policy.right_root(f, g, last_f - pair->first, last_g - pair->second, w);
  }
  if (found.lo < w.lo || found.hi > w.hi || found.lo > found.hi ||
      (found.lo == found.hi && !(found.has_lo && found.has_hi)))
    return {};
  return found;
}

/// Half of the windows begin or end where two lines cross, up to a few floats.
void draw_window(Draw& choices, LinePairs& pairs) {
  const Line<double> x = pairs.f[choices.choose(pairs.f.size() - 1)];
  const Line<double> y = pairs.g[choices.choose(pairs.g.size() - 1)];
  const double slope = x.slope + y.slope;
  if (slope == 0 || choices.coin()) return;
  const double t = choices.nudged(-((x.intercept + y.intercept) / slope), 2);
  const bool begins = choices.coin();
  if (begins && 0 <= t && t <= pairs.window.hi) pairs.window.lo = t;
  if (!begins && pairs.window.lo <= t && t <= 4) pairs.window.hi = t;
}

/// To where products of two of their numbers are subnormal or 0.
void make_tiny(Draw& choices, LinePairs& pairs) {
  const int scale = choices.integer(-545, -530);
  for (auto* lines : {&pairs.f, &pairs.g}) {
    for (Line<double>& line : *lines) {
      line = {std::ldexp(line.slope, scale), std::ldexp(line.intercept, scale)};
    }
  }
}

/// The two lists of lines that Step III walks along.
using BothLists = std::array<Lines<double>, 2>;

template <class Policy>
void claim_follows(Draw& d, const Policy& policy, const BothLists& lists,
                   const TimeWindow<double>& w) {
  const auto found = separation(policy, lists[0], lists[1], w);
  const auto literal = literal_separation(policy, lists[0], lists[1], w);
  if (found) show(d, "found", TimeWindow<double>{found->lo, found->hi});
  if (literal) show(d, "literal", TimeWindow<double>{literal->lo, literal->hi});
  show(d, "window", w);
  show(d, "f", lists[0]);
  show(d, "g", lists[1]);
  CLAIM(found.has_value() == literal.has_value());
  if (!found) return;
  CLAIM(found->lo == literal->lo);
  CLAIM(found->hi == literal->hi);
  CLAIM(found->has_lo == literal->has_lo);
  CLAIM(found->has_hi == literal->has_hi);
}

/// The envelopes are raised as after Step II, by a drawn error, whose rounding moves lines that
/// were in order past each other.
template <class Policy>
void claim_envelopes_follow(Draw& d, const Policy& policy, const LinePairs& pairs, double error) {
  BothLists envelopes = selected_lines(policy, pairs);
  for (Lines<double>& envelope : envelopes) policy.raise(envelope, error);
  claim_follows(d, policy, envelopes, pairs.window);
}

/// After an error of Step II, Step III gets lists that are no envelopes. It must not go past the
/// point from which f + g falls no more.
void claim_lists_follow(Draw& d, const LinePairs& pairs) {
  BothLists lists;
  for (const Line<double>& line : pairs.f) lists[0].push_back(line);
  for (const Line<double>& line : pairs.g) lists[1].push_back(line);
  claim_follows(d, Plain(), lists, pairs.window);
}

void check_step_three(Draw& d) {
  LinePairs pairs = draw_line_pairs(d);
  draw_window(d, pairs);
  const int exponent = d.integer(-60, 0);
  const double error = std::ldexp(d.integer(0, 255), exponent);
  switch (d.choose(3)) {
    case 0:
      return claim_envelopes_follow(d, ErrorBoundIntended(), pairs, error);
    case 1:
      return claim_envelopes_follow(d, Plain(), pairs, error);
    case 2:
      return claim_lists_follow(d, pairs);
    default:
      // There, Phi < -eps holds of no line, and what Step III walks along is no envelope.
      make_tiny(d, pairs);
      return claim_envelopes_follow(d, ErrorBoundPrinted(), pairs, std::ldexp(error, -541));
  }
}

}  // namespace

std::vector<Property> step_three_claims() {
  return {
      {"paper.step_three",
       "In doubles too, and whatever Step II left, Step III ends an interval at the pairs of lines "
       "that Eqs. 7 to 9 name",
       "Section 3, Eqs. 7-9", check_step_three}};
}

}  // namespace ccdfuzz
