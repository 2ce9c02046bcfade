#include "properties/separation.hpp"

#include "properties/show.hpp"

namespace ccdfuzz {

namespace {

template <class Policy>
void check_separation(Draw& d) {
  const LinePairs pairs = show(d, "lines", draw_line_pairs(d));
  claim_separation_is_true<Policy>(pairs);
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
  };
}

}  // namespace ccdfuzz
