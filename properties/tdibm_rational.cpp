#include "properties/linear_queries.hpp"
#include "properties/no_false_negative.hpp"

namespace ccdfuzz {

std::vector<Property> tdibm_rational_claims() {
  constexpr auto kMethod = "tdibm-rational", kSource = "src/ccd/rational/DERIVATION.md";
  return {
      {"tdibm-rational.no_false_negative", "No proven contact is missed, and none reported late",
       kSource, misses_nothing(kMethod)},
      {"tdibm-rational.no_false_negative_fine",
       "No proven contact is missed, and none reported late, for coordinates of many bits and "
       "contacts about the ends of windows",
       kSource, misses_nothing(kMethod, kManyBits)},
      {"tdibm-rational.no_false_negative_linear",
       "No contact of a degenerate linear query is missed, and none reported late", kSource,
       misses_nothing_linear(kMethod, kQuickSearch)},
      {"tdibm-rational.trace", "No pair of boxes that holds a contact is dropped on the way",
       kSource, keeps_contacts(kMethod, kElsewhere)},
  };
}

}  // namespace ccdfuzz
