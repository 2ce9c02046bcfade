#include "properties/registry.hpp"

#include <fmt/format.h>

#include "properties/dyadic_round_trip.hpp"
#include "properties/envelope.hpp"
#include "properties/sub_patch.hpp"

namespace ccdfuzz {

const std::vector<Property>& properties() {
  constexpr auto kHolds = Expectation::kHolds;
  constexpr auto kFails = Expectation::kFails;
  static const std::vector<Property> all = {
      {"dyadic.round_trip",
       "A double goes to exact numbers and back without loss, and both exact "
       "number types agree on every sum, difference, product and order",
       "Section 5.4", kHolds, check_dyadic_round_trip},
      {"sub_patch.is_the_restriction", "The sub-patch over a cell equals the patch there, exactly",
       "Appendix A (b)", kHolds, check_sub_patch_is_the_restriction},
      {"tdibm.envelope", "The envelope of Step II is nowhere below the exact maximum of its lines",
       "Section 3, Eqs. 5-6, in double arithmetic", kFails, check_envelope<Plain>},
      {"tdibm-e.envelope",
       "The envelope of Step II, raised by eps_constr, is nowhere below the "
       "exact maximum of its lines",
       "Section 4.4, Eqs. 11-16", kHolds, check_envelope<ErrorBoundIntended>},
      {"tdibm.separation", "Where Step III finds two patches separated, they are",
       "Section 3, Eqs. 7-10, in double arithmetic", kFails, check_separation<Plain>},
      {"tdibm-e.separation", "Where Step III finds two patches separated, they are",
       "Section 4.5, Eqs. 17-18, with eps_Phi's sign as Fig. 2 means it", kHolds,
       check_separation<ErrorBoundIntended>},
      {"tdibm-e-literal.separation", "Where Step III finds two patches separated, they are",
       "Sections 4.4 and 4.5 with eps_Phi's sign as printed", kFails,
       check_separation<ErrorBoundPrinted>},
  };
  return all;
}

Result<Property> property_named(std::string_view name) {
  std::string names;
  for (const Property& p : properties()) {
    if (p.name == name) return p;
    names += fmt::format("{}{}", names.empty() ? "" : ", ", p.name);
  }
  return input_error("", fmt::format("no property \"{}\"; there are: {}", name, names));
}

}  // namespace ccdfuzz
