#pragma once

#include "properties/property.hpp"

namespace ccdfuzz {

/// The errors of doubles that tdibm-c rests on, each held to its derivation in exact arithmetic: a
/// bound that is too small need not lose a contact that anybody draws.
std::vector<Property> certified_bound_properties();

}  // namespace ccdfuzz
