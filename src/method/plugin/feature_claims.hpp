#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "method/features.hpp"
#include "method/plugin/ccdfuzz_plugin.h"

namespace ccdfuzz {

/// How a plug-in claims a feature: by a field of its description, in C by a bit of its claims.
struct FeatureClaim {
  bool Features::*feature;
  const char* field;
  std::uint64_t bit;
};
inline constexpr auto kFeatureClaims = std::to_array<FeatureClaim>({
    {&Features::ends, "takes_ends", CCDFUZZ_TAKES_ENDS},
    {&Features::separation, "takes_separation", CCDFUZZ_TAKES_SEPARATION},
    {&Features::weights, "takes_weights", CCDFUZZ_TAKES_WEIGHTS},
    {&Features::bodies, "takes_bodies", CCDFUZZ_TAKES_BODIES},
    {&Features::turns, "takes_turns", CCDFUZZ_TAKES_TURNS},
    {&Features::angles, "takes_angles", CCDFUZZ_TAKES_ANGLES},
    {&Features::spins, "takes_spins", CCDFUZZ_TAKES_SPINS},
    {&Features::meshes, "takes_meshes", CCDFUZZ_TAKES_MESHES},
    {&Features::one_sided, "takes_one_sided", CCDFUZZ_TAKES_ONE_SIDED},
    {&Features::trims, "takes_trims", CCDFUZZ_TAKES_TRIMS},
});

inline constexpr Features kAllFeatures = [] {
  Features all;
  for (const FeatureClaim& claim : kFeatureClaims) all.*claim.feature = true;
  return all;
}();

/// Those of patches; the others are of bodies.
inline constexpr Features kPatchFeatures = {
    .ends = true, .separation = true, .weights = true, .trims = true};

/// The kinds of queries beyond plain patches that are taken, as words: "ends", "one-sided".
inline std::vector<std::string> words_of(const Features& taken) {
  std::vector<std::string> words;
  for (const FeatureClaim& claim : kFeatureClaims) {
    if (!(taken.*claim.feature)) continue;
    std::string& word = words.emplace_back(std::string_view(claim.field).substr(6));  // "takes_"
    std::ranges::replace(word, '_', '-');
  }
  return words;
}

constexpr bool has_all(const Features& taken, const Features& needs) {
  return std::ranges::all_of(kFeatureClaims, [&](const FeatureClaim& claim) {
    return taken.*claim.feature || !(needs.*claim.feature);
  });
}

}  // namespace ccdfuzz
