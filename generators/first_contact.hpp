#pragma once

#include <cstdint>

#include "case/case.hpp"
#include "generators/scene.hpp"

namespace ccdfuzz {

/// Step V: whether it is proven that the patches do not touch at any t in [0, until], until < t*.
/// If so, the case says it; else it is void. A moving plane through the contact is tried first,
/// which takes no search. Then the certified double method looks for contacts: it is fast and
/// throws out most of what touches before. If it has found nothing, tdibm-rational proves. made:
/// the scene's query, as doubles. grazing: at the contact the patches move along each other.
/// max_pops: of the search, ≥ 1.
bool prove_first_contact(const Scene& scene, Case& made, const Dyadic& until, bool grazing,
                         std::uint64_t max_pops);

/// True iff tdibm-rational proves in max_pops ≥ 1 pops that the patches do not touch in [0, until],
/// after tdibm-c has found nothing.
bool proven_by_search(const Query& query, const Dyadic& until, std::uint64_t max_pops);

}  // namespace ccdfuzz
