#include "ccd/separation.hpp"
#include "properties/draw_lines.hpp"
#include "properties/error_bound.hpp"
#include "properties/exact_lines.hpp"
#include "properties/show.hpp"

namespace ccdfuzz {

namespace {

/// Two envelopes that count as exact, as Section 4.5 takes them, and a window.
struct Envelopes {
  Lines<double> f, g;
  TimeWindow<double> window;
};

/// Half of the windows begin where the first two lines cross, or end where the last two do, up to a
/// few floats. There Eqs. 7, 8b and 9b are hard to judge.
Envelopes draw_envelopes(Draw& d) {
  const LinePairs pairs = draw_line_pairs(d);
  const auto [f, g] = selected_lines(ErrorBoundIntended(), pairs);
  Envelopes drawn{f, g, pairs.window};
  const bool at_start = d.coin(), near = d.coin();
  const Line<double>&x = at_start ? drawn.f[0] : drawn.f.back(),
        &y = at_start ? drawn.g[0] : drawn.g.back();
  const double slope = x.slope + y.slope;
  if (near && slope != 0) {
    const double t = d.nudged(-((x.intercept + y.intercept) / slope), 20);
    if (at_start && 0 <= t && t <= drawn.window.hi) drawn.window.lo = t;
    if (!at_start && drawn.window.lo <= t && t <= 4) drawn.window.hi = t;
  }
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

std::vector<Property> sweep_claims() {
  return {
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
