#include "properties/envelope.hpp"

#include <algorithm>

#include "properties/show.hpp"

namespace ccdfuzz {

namespace {

void check_sorting(Draw& d) {
  const LinePairs pairs = draw_line_pairs(d);
  const Lines<double> sorted = sorted_lines(pairs.f);
  const auto before = [](const Line<double>& x, const Line<double>& y) {
    return x.slope < y.slope || (x.slope == y.slope && x.intercept < y.intercept);
  };
  const auto same = [](const Line<double>& x, const Line<double>& y) {
    return x.slope == y.slope && x.intercept == y.intercept;
  };
  show(d, "lines", pairs.f);
  CLAIM(std::is_sorted(sorted.begin(), sorted.end(), before));
  CLAIM(std::is_permutation(sorted.begin(), sorted.end(), pairs.f.begin(), pairs.f.end(), same));
}

template <class Policy>
void check_envelope(Draw& d) {
  const LinePairs pairs = draw_line_pairs(d);
  show(d, "lines", pairs.f);
  show(d, "window", pairs.window);
  claim_envelope_is_never_below<Policy>(pairs.f, pairs.window);
}

}  // namespace

std::vector<Property> envelope_claims() {
  return {
      {"lines.sorting", "Sorted lines are the same lines, by slope and intercept",
       "Section 3, Step II", check_sorting},
      {"tdibm.envelope", "The envelope of Step II is nowhere below the exact maximum of its lines",
       "Section 3, Eqs. 5-6, in double arithmetic", check_envelope<Plain>, kFails},
      {"tdibm-e.envelope",
       "The envelope of Step II, raised by eps_constr, is nowhere below the exact maximum of its "
       "lines",
       "Section 4.4, Eqs. 11-16", check_envelope<ErrorBoundIntended>},
  };
}

}  // namespace ccdfuzz
