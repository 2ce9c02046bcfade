#include "properties/envelope.hpp"
#include "properties/show.hpp"

namespace ccdfuzz {

namespace {

template <class Policy>
void check_separation(Draw& d) {
  const LinePairs pairs = show(d, "lines", draw_line_pairs(d));
  claim_separation_is_true<Policy>(pairs);
}

/// An end that Step III finds inside of the window is the root of two lines. Their sum falls at a
/// start and rises at an end, however much is rounded.
template <class Policy>
void check_ends(Draw& d) {
  const Policy policy;
  const LinePairs pairs = show(d, "lines", draw_touching_pairs(d));
  const TimeWindow<double>& w = pairs.window;
  const Lines<double> f = envelope_of(policy, pairs.f, w);
  const Lines<double> g = envelope_of(policy, pairs.g, w);
  const auto found = separation(policy, f, g, w);
  if (!found) return;
  bool falls_at_lo = found->has_lo, rises_at_hi = found->has_hi;
  for (int i = 0; i < f.size(); ++i) {
    for (int j = 0; j < g.size(); ++j) {
      const double slope = f[i].slope + g[j].slope;
      falls_at_lo = falls_at_lo || (slope < 0 && policy.left_root(f, g, i, j, w) == found->lo);
      rises_at_hi = rises_at_hi || (slope > 0 && policy.right_root(f, g, i, j, w) == found->hi);
    }
  }
  show(d, "from", found->lo);
  show(d, "to", found->hi);
  CLAIM(falls_at_lo);
  CLAIM(rises_at_hi);
}

}  // namespace

std::vector<Property> separation_claims() {
  return {
      {"tdibm.separation", "Where Step III finds two patches separated, they are",
       "Section 3, Eqs. 7-10, in double arithmetic", check_separation<Plain>, kFails},
      {"tdibm-e.separation", "Where Step III finds two patches separated, they are",
       "Section 4.5, Eqs. 17-18, with eps_Phi's sign as Fig. 2 means it",
       check_separation<ErrorBoundIntended>},
      {"tdibm-e-literal.separation", "Where Step III finds two patches separated, they are",
       "Sections 4.4 and 4.5, with eps_Phi's sign as printed", check_separation<ErrorBoundPrinted>,
       kFails},
      {"tdibm.ends",
       "An end that Step III finds is the root of two lines that fall there, or rise if it is the "
       "right one, also where rounding misleads it, and with the guards of Sections 4.4 and 4.5",
       "Section 3, Eqs. 7-10, in double arithmetic",
       [](Draw& d) { d.coin() ? check_ends<ErrorBoundIntended>(d) : check_ends<Plain>(d); }},
  };
}

}  // namespace ccdfuzz
