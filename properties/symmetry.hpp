#pragma once

#include <optional>
#include <string_view>

#include "base/enum_names.hpp"
#include "case/case.hpp"
#include "generators/draw/draw.hpp"

namespace ccdfuzz {

/// Changes of a query under which the same contact stays a contact.
enum class Symmetry : std::uint8_t {
  kSwapPatches,
  kReverseParameters,  ///< for one patch: u → 1 − u, u ↔ v, any order of (w, u, v)
  kPermuteAxes,        ///< in space
  kMirror,             ///< one coordinate is negated
  kScale,              ///< all lengths times a power of two
  kScaleTime,          ///< all times times a power of two
  kTranslate,          ///< both patches by the same vector
  kCommonVelocity,     ///< both patches get the same velocity on top
  kReverseTime,        ///< t → t_max − t
  kElevate,            ///< one patch with higher degrees, both larger by the factor that takes
  kPart,               ///< one patch cut down to a cell that holds its contact point
};
constexpr std::array<std::string_view, 11> names_of(Symmetry) {
  return {"swap_patches", "reverse_parameters", "permute_axes", "mirror",  "scale", "scale_time",
          "translate",    "common_velocity",    "reverse_time", "elevate", "part"};
}
inline constexpr auto kSymmetries = all_of(Symmetry{});

/// The case after a drawn change of this kind, its truth being the witness alone. Nothing if some
/// number of it is not a double then. Requires a witness with dyadic parameters.
std::optional<Case> transformed(const Case& value, Symmetry symmetry, Draw& choices);

}  // namespace ccdfuzz
