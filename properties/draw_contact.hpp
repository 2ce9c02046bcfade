#pragma once

#include "properties/choices.hpp"
#include "query/case.hpp"

namespace ccdfuzz {

/// How large the numbers of a drawn case are: all of them are multiplied by one power of two
/// between these. The patches are 2^3 across before that.
struct ScaleRange {
  int lowest = -40;
  int highest = 40;
};

/// Two moving patches of any of the four shapes, degree at most 3, that touch in an exact witness:
/// at any feature, at t* in [0, 1], asked up to t*, a little past it, or up to 2. Most often each
/// stays on its own side of a plane through the contact and moves towards it, so that the contact
/// is the first one; control points that do not bear on it are sometimes twins of others up to a
/// few floats. `truth` holds the witness alone. Errors: the choices ask for numbers that no double
/// holds.
Result<Case> draw_contact(ChoiceSource& choices, const ScaleRange& scales);

}  // namespace ccdfuzz
