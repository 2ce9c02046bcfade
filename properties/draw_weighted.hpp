#pragma once

#include "generators/contact.hpp"
#include "generators/draw_contact.hpp"
#include "properties/draw_first_contact.hpp"

namespace ccdfuzz {

/// A contact of patches of which one at least is rational, with weights of any kind
/// (draw_patch_weights). Half of them are contacts of draw_contact whose control points were pulled
/// by powers of two. The others have control points that weighted sums put at the origin. A few are
/// put elsewhere.
Contact draw_weighted_contact(Draw& choices);

/// draw_first_contact with control points pulled by powers of two: it stays the first one, and the
/// plane that proves it stays. plain, if given, gets the query before that.
FirstContact draw_weighted_first_contact(Draw& choices, Query* plain = nullptr);

}  // namespace ccdfuzz
