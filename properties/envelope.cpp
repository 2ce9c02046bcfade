#include "properties/envelope.hpp"

#include <fmt/format.h>

#include "properties/exact_lines.hpp"

namespace ccdfuzz {

namespace {

/// Sorted, selected and raised, as TdibmInclusion does it.
template <class Policy>
Lines<double> envelope_of(const Policy& policy, const std::vector<Line<double>>& lines,
                          const TimeWindow<double>& window) {
  Lines<double> sorted, envelope;
  for (const Line<double>& line : lines) {
    sorted.push_back({line.slope, policy.pulled(line.intercept)});
  }
  sort_lines(sorted);
  upper_envelope(policy, sorted, window, envelope);
  policy.raise(envelope, policy.envelope_error(sorted, CoefficientError{}, window.hi));
  return envelope;
}

}  // namespace

template <class Policy>
Check envelope_is_never_below_the_maximum(const Policy& policy,
                                          const std::vector<Line<double>>& lines,
                                          const TimeWindow<double>& window) {
  const ExactLines all = exact_lines(lines);
  const ExactLines kept = exact_lines(envelope_of(policy, lines, window));
  const Dyadic lo = Dyadic::exact(window.lo), hi = Dyadic::exact(window.hi);
  // A line less the maximum of the kept ones is concave: it is greatest at a breakpoint of these.
  for (const Instant& t : breakpoints(kept, lo, hi)) {
    if (scaled_maximum(kept, t) < scaled_maximum(all, t)) {
      return Check::fails(fmt::format("lines {} on {}: below the maximum at t = {}",
                                      to_hex_text(lines), to_hex_text(window), to_text(t)));
    }
  }
  return Check::holds();
}

template <class Policy>
Check separation_is_true(const Policy& policy, const LinePairs& pairs) {
  const Lines<double> f = envelope_of(policy, pairs.f, pairs.window);
  const Lines<double> g = envelope_of(policy, pairs.g, pairs.window);
  const auto found = separation(policy, f, g, pairs.window);
  if (!found) return Check::holds();
  const auto failure = [&](const char* what) {
    return Check::fails(
        fmt::format("f {} g {} on {}: said to be separated on {}{}, {}{}, but max f + max g {}",
                    to_hex_text(pairs.f), to_hex_text(pairs.g), to_hex_text(pairs.window),
                    found->has_lo ? '[' : '(', to_hex(found->lo), to_hex(found->hi),
                    found->has_hi ? ']' : ')', what));
  };
  const ExactLines all_f = exact_lines(pairs.f), all_g = exact_lines(pairs.g);
  const auto sign_at = [&](const Dyadic& t) {
    return (maximum(all_f, t) + maximum(all_g, t)).sign();
  };
  // max f + max g is convex: ≤ 0 at both ends and < 0 between them once means < 0 between them.
  const Dyadic lo = Dyadic::exact(found->lo), hi = Dyadic::exact(found->hi);
  if (sign_at(lo) > (found->has_lo ? -1 : 0)) return failure("is not negative at the start");
  if (sign_at(hi) > (found->has_hi ? -1 : 0)) return failure("is not negative at the end");
  if (lo != hi && sign_at((lo + hi).scaled(-1)) >= 0) return failure("is 0 between the ends");
  return Check::holds();
}

template <class Policy>
Check ends_are_of_their_side(const Policy& policy, const LinePairs& pairs) {
  const TimeWindow<double>& w = pairs.window;
  const Lines<double> f = envelope_of(policy, pairs.f, w);
  const Lines<double> g = envelope_of(policy, pairs.g, w);
  const auto found = separation(policy, f, g, w);
  if (!found) return Check::holds();
  bool falls = found->has_lo, rises = found->has_hi;
  for (int i = 0; i < f.size(); ++i) {
    for (int j = 0; j < g.size(); ++j) {
      const double slope = f[i].slope + g[j].slope;
      falls = falls || (slope < 0 && policy.left_root(f, g, i, j, w) == found->lo);
      rises = rises || (slope > 0 && policy.right_root(f, g, i, j, w) == found->hi);
    }
  }
  if (falls && rises) return Check::holds();
  return Check::fails(fmt::format("f {} g {} on {}: no two lines {} at {}", to_hex_text(pairs.f),
                                  to_hex_text(pairs.g), to_hex_text(w), falls ? "rise" : "fall",
                                  to_hex(falls ? found->hi : found->lo)));
}

#define CCDFUZZ_INSTANTIATE(Policy)                                                \
  template Check envelope_is_never_below_the_maximum(                              \
      const Policy&, const std::vector<Line<double>>&, const TimeWindow<double>&); \
  template Check separation_is_true(const Policy&, const LinePairs&);              \
  template Check ends_are_of_their_side(const Policy&, const LinePairs&);
CCDFUZZ_INSTANTIATE(Plain)
CCDFUZZ_INSTANTIATE(ErrorBoundIntended)
CCDFUZZ_INSTANTIATE(ErrorBoundPrinted)
#undef CCDFUZZ_INSTANTIATE

std::vector<Property> envelope_properties() {
  constexpr auto kHolds = Expectation::kHolds, kFails = Expectation::kFails;
  return {
      {"tdibm.envelope", "The envelope of Step II is nowhere below the exact maximum of its lines",
       "Section 3, Eqs. 5-6, in double arithmetic", kFails, check_envelope<Plain>},
      {"tdibm-e.envelope",
       "The envelope of Step II, raised by eps_constr, is nowhere below the exact maximum of its "
       "lines",
       "Section 4.4, Eqs. 11-16", kHolds, check_envelope<ErrorBoundIntended>},
      {"tdibm.separation", "Where Step III finds two patches separated, they are",
       "Section 3, Eqs. 7-10, in double arithmetic", kFails, check_separation<Plain>},
      {"tdibm-e.separation", "Where Step III finds two patches separated, they are",
       "Section 4.5, Eqs. 17-18, with eps_Phi's sign as Fig. 2 means it", kHolds,
       check_separation<ErrorBoundIntended>},
      {"tdibm-e-literal.separation", "Where Step III finds two patches separated, they are",
       "Sections 4.4 and 4.5, with eps_Phi's sign as printed", kFails,
       check_separation<ErrorBoundPrinted>},
      {"tdibm.ends",
       "An end that Step III finds is the root of two lines that fall there, or rise if it is the "
       "right one, also where rounding misleads it",
       "Section 3, Eqs. 7-10, in double arithmetic", kHolds, check_ends<Plain>},
      {"tdibm-e.ends", "The same with the guards of Sections 4.4 and 4.5", "Sections 4.4 and 4.5",
       kHolds, check_ends<ErrorBoundIntended>},
  };
}

}  // namespace ccdfuzz
