#pragma once

#include <optional>

#include "generators/generate.hpp"
#include "generators/scene.hpp"

namespace ccdfuzz {

/// Step VI: the case of a validated scene, with the truth its kind has. Every exact number is
/// turned to the double equal to it; nullopt if one has none (the round trip of Section 5.4).
/// clear_until = t* − eps_T must have been proven.
std::optional<Case> finalize(const Scene& scene, const GeneratorOptions& options);

}  // namespace ccdfuzz
