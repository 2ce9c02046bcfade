#pragma once

#include <cstdint>
#include <optional>

#include "case/query.hpp"
#include "generators/scene.hpp"

namespace ccdfuzz {

/// Step V: a proof that the patches do not touch at any t in [0, until], until < t*, if there is
/// one. By a moving plane through the contact, if one does it, which takes no search; else by
/// tdibm-rational, once the certified double method has found nothing either: that is faster and
/// throws out most of what touches before.
/// query: the scene's, as doubles. grazing: at the contact the patches move along each other.
/// max_pops: of the search, ≥ 1.
std::optional<Absence> prove_first_contact(const Scene& scene, const Query& query,
                                           const Dyadic& until, bool grazing,
                                           std::uint64_t max_pops);

/// True iff tdibm-rational proves in max_pops ≥ 1 pops that the patches do not touch in [0, until],
/// after tdibm-c has found nothing.
bool proven_by_search(const Query& query, const Dyadic& until, std::uint64_t max_pops);

/// The same for [0, query.t_max].
bool miss_is_proven(const Query& query, std::uint64_t max_pops);

}  // namespace ccdfuzz
