#include "properties/no_false_negative.hpp"

namespace ccdfuzz {

std::vector<Property> tdibm_rational_claims() {
  return contact_claims("tdibm-rational", "src/ccd/rational/DERIVATION.md", kQuickSearch);
}

}  // namespace ccdfuzz
