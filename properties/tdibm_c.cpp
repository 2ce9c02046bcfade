#include "properties/no_false_negative.hpp"

namespace ccdfuzz {

std::vector<Property> tdibm_c_claims() {
  constexpr auto kMethod = "tdibm-c", kSource = "src/ccd/certified/DERIVATION.md";
  // Nothing that is drawn under- or overflows a double; products do both.
  constexpr ContactRange kAllScales{-1000, 900, 5};
  // What users ask with, except for a budget that static and grazing contacts exceed.
  constexpr SearchOptions kFullSearch = {1e-4, 2000, SearchOptions().max_bytes};
  std::vector<Property> claims = contact_claims(kMethod, kSource, kFullSearch);
  claims.push_back({"tdibm-c.no_false_negative_anywhere",
                    "No proven contact is missed, and none reported late, for coordinates from "
                    "2^-1000 to 2^900, degrees up to 5 and the default precision",
                    kSource, misses_nothing(kMethod, contacts_in(kAllScales), kFullSearch)});
  return claims;
}

}  // namespace ccdfuzz
