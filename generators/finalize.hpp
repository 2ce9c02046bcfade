#pragma once

#include <optional>

#include "case/case.hpp"
#include "generators/attempts.hpp"
#include "numeric/dyadic.hpp"

namespace ccdfuzz {

/// The query of two patches, to t_max: every exact number turned to the double equal to it.
/// nullopt if one has none (the round trip of Section 5.4).
std::optional<Query> to_query(const std::array<MovingPatch<Dyadic>, 2>& patches,
                              const Dyadic& t_max);

/// Makes it a positive by its witness. A construction that is wrong does not get out: the checker
/// accepts the witness, or an invariant is broken.
void say_contact(Case& value, const Witness& witness);

/// Makes it a negative that ends at t_max, which is proven to be clear: by the case's own
/// clearance, where that covers it, else by tdibm-rational.
void say_clear(Case& value, double t_max);

/// The negative, if a search in exact arithmetic proves in the options' pops that nothing touches.
Attempted proven_apart(Case value, const GeneratorOptions& options);

}  // namespace ccdfuzz
