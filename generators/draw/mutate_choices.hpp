#pragma once

#include "generators/draw/draw.hpp"

namespace ccdfuzz {

/// Choices like these: one to four numbers or stretches of them changed, copied, left out or put
/// in. Whole numbers change, so that all later ones keep their meaning where none was added or
/// removed.
ChoiceNumbers mutated(ChoiceNumbers numbers, Draw& random);

/// The beginning of a, then the end of b; both cut at the same place as far as they reach.
ChoiceNumbers crossed(const ChoiceNumbers& a, const ChoiceNumbers& b, Draw& random);

/// Choices drawn anew: small ones, which make coincidences, as often as any.
ChoiceNumbers drawn_choices(Draw& random);

}  // namespace ccdfuzz
