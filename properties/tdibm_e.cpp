#include "case/scale.hpp"
#include "properties/draw_weighted.hpp"
#include "properties/no_false_negative.hpp"
#include "properties/show.hpp"

namespace ccdfuzz {

/// The paper's methods, with error bounds and without.
std::vector<Property> tdibm_e_claims() {
  constexpr auto kAsPrinted = "Section 4.6, with eps_Phi's sign as printed";
  const DrawCase ordinary = contacts_in(kOrdinaryRange), tiny = contacts_in(kTiny),
                 huge = contacts_in(kHuge);
  std::vector<Property> claims;
  add_contact_claims(claims, "tdibm-e", "",
                     "of ordinary numbers, also after exact changes of coordinates,", "Section 4.6",
                     draw_transformed);
  add_contact_claims(claims, "tdibm-e", "_weighted", "of rational patches of ordinary numbers",
                     "Section 7, NURBS", [](Draw& d) {
                       const Contact drawn = draw_weighted_contact(d);
                       suppose(is_within_scale(drawn.query, kOrdinaryBits));
                       return case_of(drawn);
                     });
  add_contact_claims(claims, "tdibm-e", "_underflow", "about 2^-535",
                     "Section 4.6, which does not exclude underflow", tiny, kFails);
  add_contact_claims(claims, "tdibm-e", "_overflow", "about 2^510",
                     "Section 4.6, which does not exclude overflow", huge, kFails);
  add_contact_claims(claims, "tdibm-e-literal", "", "of ordinary numbers", kAsPrinted, ordinary,
                     kFails);
  add_contact_claims(claims, "tdibm", "", "of ordinary numbers", "Section 3, in double arithmetic",
                     ordinary, kFails);
  return claims;
}

}  // namespace ccdfuzz
