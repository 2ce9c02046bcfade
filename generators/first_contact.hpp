#pragma once

#include "generators/scene.hpp"

namespace ccdfuzz {

/// Step V: true iff it is proven that the patches do not touch at any t in [0, until], until < t*.
/// By a moving plane through the contact.
bool first_contact_is_proven(const Scene& scene, const Dyadic& until);

}  // namespace ccdfuzz
