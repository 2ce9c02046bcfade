#include "properties/linear_queries.hpp"
#include "properties/no_false_negative.hpp"

namespace ccdfuzz {

std::vector<Property> tdibm_c_claims() {
  constexpr auto kMethod = "tdibm-c", kSource = "src/ccd/certified/DERIVATION.md";
  // Nothing that is drawn under- or overflows a double; products do both.
  constexpr ContactRange kAllScales{-1000, 900, 5};
  // What users ask with, except for a budget that static and grazing contacts exceed.
  constexpr SearchOptions kFullSearch = {1e-4, 2000, SearchOptions().max_bytes};
  return {
      {"tdibm-c.no_false_negative", "No proven contact is missed, and none reported late", kSource,
       misses_nothing(kMethod)},
      {"tdibm-c.no_false_negative_underflow",
       "No proven contact is missed, and none reported late, for coordinates about 2^-535", kSource,
       misses_nothing(kMethod, kTiny)},
      {"tdibm-c.no_false_negative_anywhere",
       "No proven contact is missed, and none reported late, for coordinates from 2^-1000 to "
       "2^900, degrees up to 5 and the default precision",
       kSource, misses_nothing(kMethod, kAllScales, kFullSearch)},
      {"tdibm-c.no_false_negative_fine",
       "No proven contact is missed, and none reported late, for coordinates of many bits and "
       "contacts about the ends of windows",
       kSource, misses_nothing(kMethod, kManyBits)},
      {"tdibm-c.no_false_negative_linear",
       "No contact of a degenerate linear query is missed, and none reported late", kSource,
       misses_nothing_linear(kMethod, kFullSearch)},
      {"tdibm-c.trace", "No pair of boxes that holds a contact is dropped on the way", kSource,
       keeps_contacts(kMethod, kElsewhere)},
      {"tdibm-c.contact_swapped", "No contact is lost when the patches change places", kSource,
       misses_nothing_after(kMethod, Symmetry::kSwapPatches)},
      {"tdibm-c.contact_reparametrised",
       "No contact is lost when parameters are reversed or rotated", kSource,
       misses_nothing_after(kMethod, Symmetry::kReverseParameters)},
      {"tdibm-c.contact_permuted", "No contact is lost when the axes of space change places",
       kSource, misses_nothing_after(kMethod, Symmetry::kPermuteAxes)},
      {"tdibm-c.contact_mirrored", "No contact is lost in a mirror", kSource,
       misses_nothing_after(kMethod, Symmetry::kMirror)},
      {"tdibm-c.contact_translated", "No contact is lost far from the origin", kSource,
       misses_nothing_after(kMethod, Symmetry::kTranslate)},
      {"tdibm-c.contact_drifting", "No contact is lost under a common velocity", kSource,
       misses_nothing_after(kMethod, Symmetry::kCommonVelocity)},
      {"tdibm-c.contact_backwards", "No contact is lost when time runs backwards", kSource,
       misses_nothing_after(kMethod, Symmetry::kReverseTime)},
      {"tdibm-c.contact_elevated", "No contact is lost when a patch has higher degrees", kSource,
       misses_nothing_after(kMethod, Symmetry::kElevate)},
      {"tdibm-c.contact_in_a_part", "No contact is lost when a patch is cut down to a part with it",
       kSource, misses_nothing_after(kMethod, Symmetry::kPart)},
  };
}

}  // namespace ccdfuzz
