#pragma once

#include <optional>

#include "case/case.hpp"
#include "case/taxonomy.hpp"
#include "generators/scene.hpp"

namespace ccdfuzz {

/// The query of a scene, to scene.t_max: every exact number turned to the double equal to it.
/// nullopt if one has none (the round trip of Section 5.4).
std::optional<Query> to_query(const Scene& scene);

/// Makes it a negative that ends at t_max, which is proven to be clear: by the case's own
/// clearance, where that covers it, else by tdibm-rational.
void say_clear(Case& value, double t_max);

/// Step VI: the case of a validated scene, with the truth its kind has. query: to_query(scene).
/// clear: what has been proven of the time before, if anything has.
/// RP and NHP end at scene.t_max. RN and NMN end at clear->until, which they need.
Case finalize(const Scene& scene, const Query& query, CaseKind kind,
              const std::optional<Absence>& clear);

}  // namespace ccdfuzz
