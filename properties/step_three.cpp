#include <cmath>
#include <optional>
#include <utility>

#include "ccd/reading.hpp"
#include "ccd/separation.hpp"
#include "properties/draw_lines.hpp"
#include "properties/error_bound.hpp"
#include "properties/exact_lines.hpp"
#include "properties/show.hpp"

namespace ccdfuzz {

namespace {

/// Lines a[i]·t + b[i] of the max envelope of patch 1, and of the min envelope of patch 2.
struct PaperEnvelopes {
  Lines<double> first, second;
};

/// Whether Eqs. 8 and 9 are judged to hold at a pair of lines. They cross before patch 1 (alpha) or
/// patch 2 (beta) goes on to its next line, or before the end if there is none.
struct Judged {
  bool alpha = false, beta = false;
};

/// The indices alpha, beta at which the walk of Section 3 ends. Nothing if the lines end first, or
/// the distance of the envelopes no longer grows. Calls visit(alpha, beta, judged) on the way.
template <class Policy, class Visit>
std::optional<std::pair<int, int>> first_crossing(const Policy& policy,
                                                  const PaperEnvelopes& envelopes, double t_end,
                                                  const Visit& visit) {
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
    Judged judged;
    judged.beta = negative(
        beta + 1 == two.size(), [&] { return a(alpha, beta + 1); },
        [&] { return b(alpha, beta + 1); });
    judged.alpha = negative(
        alpha + 1 == one.size(), [&] { return a(alpha + 1, beta); },
        [&] { return b(alpha + 1, beta); });
    visit(alpha, beta, judged);
    if (judged.alpha && judged.beta) return std::pair(alpha, beta);
    if (!judged.alpha && (judged.beta || Policy::kAdvancesBoth)) ++alpha;
    if (!judged.beta) ++beta;
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
    const auto pair = first_crossing(policy, forth, w.hi, [](auto...) {});
    if (!pair) return {};
    found.lo = policy.left_root(f, g, pair->first, pair->second, w);
  }
  if (!found.has_hi) {
    const PaperEnvelopes back{backwards(forth.first), backwards(forth.second)};
    const auto pair = first_crossing(policy, back, -w.lo, [](auto...) {});
    if (!pair) return {};
    found.hi = policy.right_root(f, g, last_f - pair->first, last_g - pair->second, w);
  }
  if (found.lo < w.lo || found.hi > w.hi || found.lo > found.hi ||
      (found.lo == found.hi && !(found.has_lo && found.has_hi)))
    return {};
  return found;
}

/// Begins or ends a window where two lines cross, up to a few floats, if that may be one.
void end_at_crossing(Draw& choices, const Line<double>& x, const Line<double>& y, bool begins,
                     int floats, TimeWindow<double>& window) {
  const double slope = x.slope + y.slope;
  if (slope == 0) return;
  const double t = choices.nudged(-((x.intercept + y.intercept) / slope), floats);
  if (begins && 0 <= t && t <= window.hi) window.lo = t;
  if (!begins && window.lo <= t && t <= 4) window.hi = t;
}

/// Half of the windows begin or end where two lines cross.
void draw_window(Draw& choices, LinePairs& pairs) {
  if (choices.coin()) return;
  const Line<double> x = pairs.f[choices.choose(pairs.f.size() - 1)];
  const Line<double> y = pairs.g[choices.choose(pairs.g.size() - 1)];
  end_at_crossing(choices, x, y, choices.coin(), 2, pairs.window);
}

/// To the window on which methods as released look, which may begin before 0.
void widen(Draw& choices, TimeWindow<double>& window) {
  if (!choices.coin()) return;
  window.lo -= kAsReleased.window_margin;
  window.hi += kAsReleased.window_margin;
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
      widen(d, pairs.window);
      return claim_envelopes_follow(d, Plain(), pairs, error);
    case 2:
      widen(d, pairs.window);
      return claim_lists_follow(d, pairs);
    default:
      // There, Phi < -eps holds of no line, and what Step III walks along is no envelope.
      make_tiny(d, pairs);
      return claim_envelopes_follow(d, ErrorBoundPrinted(), pairs, std::ldexp(error, -541));
  }
}

/// Two envelopes that count as exact, as Section 4.5 takes them, and a window.
struct Envelopes {
  Lines<double> f, g;
  TimeWindow<double> window;
};

/// Half of the windows begin where the first two lines cross, or end where the last two do. There
/// Eqs. 7, 8b and 9b are hard to judge.
Envelopes draw_envelopes(Draw& d) {
  const LinePairs pairs = draw_line_pairs(d);
  const auto [f, g] = selected_lines(ErrorBoundIntended(), pairs);
  Envelopes drawn{f, g, pairs.window};
  const bool at_start = d.coin(), near = d.coin();
  const Line<double>&x = at_start ? drawn.f[0] : drawn.f.back(),
        &y = at_start ? drawn.g[0] : drawn.g.back();
  if (near) end_at_crossing(d, x, y, at_start, 20, drawn.window);
  show(d, "window", drawn.window);
  show(d, "f", drawn.f);
  show(d, "g", drawn.g);
  return drawn;
}

EndValue<Dyadic> exact_sum(const Line<double>& x, const Line<double>& y, double t) {
  const Line<Dyadic> f = exact_line(x), g = exact_line(y);
  return {f.slope + g.slope, f.intercept + g.intercept, Dyadic::exact(t)};
}

bool policy_starts_below(const Envelopes& e) {
  return ErrorBoundIntended::starts_below(e.f[0], e.g[0], e.window.lo);
}

/// The way of Section 3 from the left.
struct Walk {
  std::vector<std::array<int, 2>> pairs;
  bool found = false;          ///< the last pair is the one that crosses
  bool missed_at_end = false;  ///< Eq. 8b or 9b is true of a pair, and was judged not to be
};

Walk walk(const Envelopes& e) {
  Walk out;
  const auto visit = [&](int i, int j, const Judged& judged) {
    out.pairs.push_back({i, j});
    const bool is_last = judged.beta ? !judged.alpha && i + 1 == e.f.size() : j + 1 == e.g.size();
    const bool true_at_end = exact_sum(e.f[i], e.g[j], e.window.hi).value().sign() < 0;
    out.missed_at_end = out.missed_at_end || (is_last && true_at_end);
  };
  const PaperEnvelopes forth{e.f, upside_down(e.g)};
  out.found = first_crossing(ErrorBoundIntended(), forth, e.window.hi, visit).has_value();
  return out;
}

/// Eq. 18. Let the exact Psi_max be < 0, the computed one not below −eps, and the next line of f
/// less steep than that of g. Pull both envelopes apart by delta. Then the crossing with f's next
/// line is no earlier than the crossing that was missed.
void check_eq_18(Draw& d) {
  const LinePairs pairs = draw_line_pairs(d);
  const auto f = show(d, "f", draw_sorted(d, 2, pairs.f));
  const Line<double> g = show(d, "g", pairs.g[d.choose(pairs.g.size() - 1)]);
  const EndValue<Dyadic> now = exact_sum(f[0], g, 0), next = exact_sum(f[1], g, 0);
  suppose(now.slope < next.slope && next.slope.sign() < 0);
  const ProductDifference<Dyadic> exact{next.slope, now.intercept, now.slope, next.intercept};
  const ProductDifference<double> psi{f[1].slope + g.slope, f[0].intercept + g.intercept,
                                      f[0].slope + g.slope, f[1].intercept + g.intercept};
  suppose(exact.value().sign() < 0);
  suppose(-theorem_4_1_bound(exact.magnitude(), 4) <= Dyadic::exact(psi.value()));
  const Dyadic delta_d = std::max(abs(now.intercept), abs(next.intercept));
  const Dyadic delta = theorem_4_1_bound(delta_d.scaled(1), 4);
  // −d/c ≤ −(d' + 2 delta)/c' with c < c' < 0, times c·c' > 0.
  const Dyadic missed = now.intercept * next.slope;
  const Dyadic computed = (next.intercept + delta.scaled(1)) * now.slope;
  CLAIM(computed <= missed);
}

/// C.3: at every pair of the path but the last, "the situation corresponds to case 1", in Fig. 3
/// c_beta > c_(alpha+1). That holds for the next line of the step, alpha + 1 or beta + 1.
void check_path_is_case_1(Draw& d) {
  const Envelopes e = draw_envelopes(d);
  suppose(!policy_starts_below(e));
  const Walk path = walk(e);
  suppose(path.found && path.pairs.size() >= 2);
  for (std::size_t k = 1; k < path.pairs.size(); ++k) {
    const auto [i, j] = path.pairs[k];
    show(d, "pair", path.pairs[k]);
    CLAIM(exact_sum(e.f[i], e.g[j], 0).slope.sign() < 0);
  }
}

/// Section 4.5: where Eq. 7 is judged not to hold, rightly or not. If f + g does not fall, the
/// sweep ends at once. If it falls, the end found is not before t^L.
void check_eq_7(Draw& d) {
  const Envelopes e = draw_envelopes(d);
  suppose(!policy_starts_below(e));
  const auto found = separation(ErrorBoundIntended(), e.f, e.g, e.window);
  if (!found) return;
  show(d, "left end", found->lo);
  CLAIM(exact_sum(e.f[0], e.g[0], 0).slope.sign() < 0);
  CLAIM(e.window.lo <= found->lo);
}

void check_eq_8b_9b_omit(Draw& d) {
  const Envelopes e = draw_envelopes(d);
  suppose(!policy_starts_below(e) && walk(e).missed_at_end);
  CLAIM(!separation(ErrorBoundIntended(), e.f, e.g, e.window));
}

}  // namespace

std::vector<Property> step_three_claims() {
  return {
      {"paper.step_three",
       "In doubles too, and whatever Step II left, Step III ends an interval at the pairs of lines "
       "that Eqs. 7 to 9 name",
       "Section 3, Eqs. 7-9", check_step_three},
      {"paper.eq_18",
       "After one wrong judgement in case 3, envelopes pulled apart by delta each meet no earlier "
       "than those that were missed",
       "Eq. 18", check_eq_18},
      {"paper.path_is_case_1",
       "At every pair of the sweep's path but the last, the line that it goes on to leaves f + g "
       "falling",
       "Appendix C.3, by what each step goes on to", check_path_is_case_1},
      {"paper.eq_7",
       "If the first two lines are not judged to be in order, nothing is separated where they do "
       "not come apart, and else no left end is before the window",
       "Section 4.5, on Eq. 7", check_eq_7},
      {"paper.eq_8b_9b_omit", "A wrong judgement at the end of an envelope excludes nothing",
       "Section 4.5, on Eqs. 8b and 9b", check_eq_8b_9b_omit},
  };
}

}  // namespace ccdfuzz
