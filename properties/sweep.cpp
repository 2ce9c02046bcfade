#include <fmt/format.h>

#include "ccd/separation.hpp"
#include "properties/draw_lines.hpp"
#include "properties/error_bound.hpp"
#include "properties/exact_lines.hpp"
#include "properties/property.hpp"

namespace ccdfuzz {

namespace {

/// Two envelopes that count as exact, as Section 4.5 takes them, and a window.
struct Envelopes {
  Lines<double> f, g;
  TimeWindow<double> window;

  Check fails(const std::string& what) const {
    const auto text = [](const Lines<double>& lines) {
      return to_hex_text(std::vector<Line<double>>(lines.begin(), lines.end()));
    };
    return Check::fails(
        fmt::format("f {} g {} on {}: {}", text(f), text(g), to_hex_text(window), what));
  }
};

/// Half of the windows begin where the first two lines cross or end where the last two do, up to a
/// few floats: there Eqs. 7, 8b and 9b are hard to judge.
Envelopes draw_envelopes(Draw& choices) {
  const LinePairs pairs = draw_line_pairs(choices);
  const ErrorBoundIntended policy;
  Envelopes drawn;
  drawn.window = pairs.window;
  upper_envelope(policy, sorted_lines(pairs.f), pairs.window, drawn.f);
  upper_envelope(policy, sorted_lines(pairs.g), pairs.window, drawn.g);
  const bool at_start = choices.coin(), near = choices.coin();
  const Line<double>&x = at_start ? drawn.f[0] : drawn.f.back(),
        &y = at_start ? drawn.g[0] : drawn.g.back();
  const double slope = x.slope + y.slope;
  if (!near || slope == 0) return drawn;
  const double t = choices.nudged(-((x.intercept + y.intercept) / slope), 20);
  if (at_start && 0 <= t && t <= drawn.window.hi) drawn.window.lo = t;
  if (!at_start && drawn.window.lo <= t && t <= 4) drawn.window.hi = t;
  return drawn;
}

EndValue<Dyadic> exact_sum(const Line<double>& x, const Line<double>& y, double t) {
  const Line<Dyadic> f = exact_line(x), g = exact_line(y);
  return {f.slope + g.slope, f.intercept + g.intercept, Dyadic::exact(t)};
}

bool policy_starts_below(const Envelopes& e) {
  return ErrorBoundIntended::starts_below(e.f[0], e.g[0], e.window.lo);
}

/// The pairs of lines that the sweep from the left looks at.
struct Walk {
  std::vector<std::array<int, 2>> pairs;
  bool found = false;          ///< the last pair is the one that crosses
  bool missed_at_end = false;  ///< Eq. 8b or 9b is true of a pair, and was judged not to be
};

Walk walk(const Envelopes& e) {
  const ErrorBoundIntended policy;
  const double end = e.window.hi;
  Walk out;
  for (int i = 0, j = 0; e.f[i].slope + e.g[j].slope < 0;) {
    out.pairs.push_back({i, j});
    const bool true_at_end = exact_sum(e.f[i], e.g[j], end).value().sign() < 0;
    if (!detail::crosses_within<1>(policy, e.g, j, e.f[i], end)) {
      out.missed_at_end = out.missed_at_end || (true_at_end && j + 1 == e.g.size());
      if (++j == e.g.size()) return out;
    } else if (!detail::crosses_within<1>(policy, e.f, i, e.g[j], end)) {
      out.missed_at_end = out.missed_at_end || (true_at_end && i + 1 == e.f.size());
      if (++i == e.f.size()) return out;
    } else {
      out.found = true;
      return out;
    }
  }
  return out;
}

/// Eq. 18: where Psi_max < 0 in truth and the computed one is not below −eps, and the next line of
/// f is still less steep than that of g, then the crossing with f's next line, of envelopes pulled
/// apart by delta each, is no earlier than the crossing that was missed.
Check check_eq_18(Draw& choices) {
  const LinePairs pairs = draw_line_pairs(choices);
  const Lines<double> f = sorted_lines(pairs.f);
  if (f.size() < 2) return Check::discarded("one line");
  const auto i = static_cast<int>(choices.choose(static_cast<std::uint64_t>(f.size() - 2)));
  const Line<double> g = pairs.g[choices.choose(pairs.g.size() - 1)];
  const EndValue<Dyadic> now = exact_sum(f[i], g, 0), next = exact_sum(f[i + 1], g, 0);
  if (next.slope.sign() >= 0 || !(now.slope < next.slope)) return Check::discarded("not case 3");
  const ProductDifference<Dyadic> exact{next.slope, now.intercept, now.slope, next.intercept};
  const ProductDifference<double> psi{f[i + 1].slope + g.slope, f[i].intercept + g.intercept,
                                      f[i].slope + g.slope, f[i + 1].intercept + g.intercept};
  if (exact.value().sign() >= 0) return Check::discarded("they do not cross there");
  if (Dyadic::exact(psi.value()) < -theorem_4_1_bound(exact.magnitude(), 4)) {
    return Check::discarded("judged rightly");
  }
  const Dyadic delta_d = std::max(abs(now.intercept), abs(next.intercept));
  const Dyadic delta = theorem_4_1_bound(delta_d.scaled(1), 4);
  // −d/c ≤ −(d' + 2 delta)/c' with c < c' < 0, times c·c' > 0.
  const Dyadic missed = now.intercept * next.slope;
  const Dyadic computed = (next.intercept + delta.scaled(1)) * now.slope;
  if (computed <= missed) return Check::holds();
  return Check::fails(fmt::format("f {} line {}, g ({}, {}): Delta_t > 0", to_hex_text(pairs.f), i,
                                  to_hex(g.slope), to_hex(g.intercept)));
}

/// C.3: at every pair of the path but the last, "the situation corresponds to case 1", in Fig. 3
/// c_beta > c_(alpha+1). That is so of the line that the step goes on to, alpha + 1 or beta + 1.
Check check_path_is_case_1(Draw& choices) {
  const Envelopes e = draw_envelopes(choices);
  if (policy_starts_below(e)) return Check::discarded("no sweep");
  const Walk path = walk(e);
  if (!path.found || path.pairs.size() < 2) return Check::discarded("no path");
  for (std::size_t k = 1; k < path.pairs.size(); ++k) {
    const auto [i, j] = path.pairs[k];
    if (exact_sum(e.f[i], e.g[j], 0).slope.sign() >= 0) {
      return e.fails(fmt::format("step {} of the path goes on to another case", k));
    }
  }
  return Check::holds();
}

/// Section 4.5: where Eq. 7 is wrongly judged and f + g does not fall, the sweep ends at once.
Check check_eq_7_terminates(Draw& choices) {
  const Envelopes e = draw_envelopes(choices);
  if (policy_starts_below(e)) return Check::discarded("below from the start");
  if (exact_sum(e.f[0], e.g[0], 0).slope.sign() < 0) return Check::discarded("it falls");
  return separation(ErrorBoundIntended(), e.f, e.g, e.window) ? e.fails("an interval was found")
                                                              : Check::holds();
}

/// Section 4.5: where Eq. 7 is wrongly judged and f + g falls, the end found is not before t^L,
/// from which on they are separated.
Check check_eq_7_clamped(Draw& choices) {
  const Envelopes e = draw_envelopes(choices);
  if (exact_sum(e.f[0], e.g[0], e.window.lo).value().sign() >= 0 || policy_starts_below(e)) {
    return Check::discarded("judged rightly");
  }
  const auto found = separation(ErrorBoundIntended(), e.f, e.g, e.window);
  if (!found || e.window.lo <= found->lo) return Check::holds();
  return e.fails(fmt::format("the left end {} is before the window", to_hex(found->lo)));
}

/// Section 4.5: a wrong judgement of Eq. 8b or 9b leads to no interval.
Check check_eq_8b_9b_omit(Draw& choices) {
  const Envelopes e = draw_envelopes(choices);
  if (policy_starts_below(e) || !walk(e).missed_at_end) return Check::discarded("judged rightly");
  return separation(ErrorBoundIntended(), e.f, e.g, e.window) ? e.fails("an interval was found")
                                                              : Check::holds();
}

}  // namespace

std::vector<Property> sweep_claims() {
  constexpr auto kHolds = Expectation::kHolds;
  return {
      {"paper.eq_18",
       "After one wrong judgement in case 3, envelopes pulled apart by delta each meet no earlier "
       "than those that were missed",
       "Eq. 18", kHolds, check_eq_18},
      {"paper.path_is_case_1",
       "At every pair of the sweep's path but the last, the line that it goes on to leaves f + g "
       "falling",
       "Appendix C.3, by what each step goes on to", kHolds, check_path_is_case_1},
      {"paper.eq_7_terminates",
       "If the first two lines are not judged to be in order and do not come apart, nothing is "
       "separated",
       "Section 4.5, on Eq. 7", kHolds, check_eq_7_terminates},
      {"paper.eq_7_clamped",
       "If the first two lines are in order and judged not to be, no left end is before the window",
       "Section 4.5, on Eq. 7", kHolds, check_eq_7_clamped},
      {"paper.eq_8b_9b_omit", "A wrong judgement at the end of an envelope excludes nothing",
       "Section 4.5, on Eqs. 8b and 9b", kHolds, check_eq_8b_9b_omit},
  };
}

}  // namespace ccdfuzz
