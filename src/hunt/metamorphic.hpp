#pragma once

#include <vector>

#include "properties/property.hpp"

namespace ccdfuzz {

/// Claims that a method answers two queries alike that ask the same in other words, exactly. Each
/// is about any method, and of queries that a hunt draws for that method.
///
/// Two answers differ if one is a hit and the other a miss, or two hits are farther apart than both
/// tolerances together. That counts if one of the two is right, and the other is wrong beyond its
/// tolerance: missed, late or a false positive (judge), or early. A hit is early if bodies or
/// linear patches are proven to be farther apart than its tolerance in space until then. With a
/// tolerance in time it is if no contact comes within that. Where neither is claimed, none is
/// early. A method that claims to miss nothing may have early hits and false positives, since it is
/// conservative. What is refused, undecided or a fault is discarded.
std::vector<Property> metamorphic_claims();

}  // namespace ccdfuzz
