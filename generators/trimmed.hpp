#pragma once

#include <tl/expected.hpp>

#include "generators/draw/draw.hpp"
#include "generators/generate.hpp"

namespace ccdfuzz {

/// One attempt at a case of the family trimmed, or why it was thrown away. It is a regular
/// one-sided case with loops about the contact, of one surface or both. The contact of a positive
/// is inside of a loop, on an edge, on a vertex or one float inside. Or it is in a sliver, where
/// loops touch, or on an island in a hole. Else the whole patches touch one float outside or in a
/// hole at t*. Those with loops touch at another place later, at t_max, which the witness says. A
/// moving plane proves that nothing touches before t*. A negative ends at t*, when only the whole
/// patches touch. A search in exact arithmetic proves it.
tl::expected<Case, Discard> trimmed_case(const GeneratorOptions& options, const Dyadic& eps_t,
                                         Draw& draw);

}  // namespace ccdfuzz
