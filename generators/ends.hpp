#pragma once

#include <tl/expected.hpp>

#include "generators/draw/draw.hpp"
#include "generators/generate.hpp"
#include "generators/similar.hpp"

namespace ccdfuzz {

/// Moves all positions by a little and all ends by much, as far as their bits allow. So differences
/// of the two have more bits. nullopt if they have no room. changes, if given, gets both steps.
std::optional<Query> parted(const Query& query, Draw& draw,
                            std::array<Similarity, 2>* changes = nullptr);

/// One attempt at a case of the family ends, or why it was thrown away. It is a regular or
/// interior-time case whose patches have ends. Some difference of an end to the start is no double.
tl::expected<Case, Discard> ends_case(const GeneratorOptions& options, const Dyadic& eps_t,
                                      Draw& draw);

}  // namespace ccdfuzz
