#include "properties/no_false_negative.hpp"

namespace ccdfuzz {

/// The paper's methods, with error bounds and without.
std::vector<Property> tdibm_e_claims() {
  constexpr auto kFails = Expectation::kFails;
  constexpr auto kMissesNothing = "No proven contact is missed, and none reported late",
                 kDropsNothing = "No pair of boxes that holds a contact is dropped on the way";
  return {
      {"tdibm-e.no_false_negative",
       "No proven contact is missed, and none reported late, where nothing underflows, also after "
       "changes of coordinates that keep it",
       "Section 4.6", misses_nothing("tdibm-e", draw_transformed)},
      {"tdibm-e.trace", kDropsNothing, "Section 4.6", keeps_contacts("tdibm-e")},
      {"tdibm-e.no_false_negative_underflow",
       "No proven contact is missed, and none reported late, for coordinates about 2^-535",
       "Section 4.6, which does not exclude underflow",
       misses_nothing("tdibm-e", contacts_in(kTiny)), kFails},
      {"tdibm-e.trace_underflow", kDropsNothing, "Section 4.6, for coordinates about 2^-535",
       keeps_contacts("tdibm-e", contacts_in(kTiny)), kFails},
      {"tdibm-e-literal.no_false_negative",
       "No proven contact is missed, and none reported late, where nothing underflows",
       "Section 4.6, with eps_Phi's sign as printed", misses_nothing("tdibm-e-literal"), kFails},
      {"tdibm-e-literal.trace", kDropsNothing, "Section 4.6, with eps_Phi's sign as printed",
       keeps_contacts("tdibm-e-literal"), kFails},
      {"tdibm.no_false_negative", kMissesNothing, "Section 3, in double arithmetic",
       misses_nothing("tdibm"), kFails},
      {"tdibm.trace", kDropsNothing, "Section 3, in double arithmetic", keeps_contacts("tdibm"),
       kFails},
  };
}

}  // namespace ccdfuzz
