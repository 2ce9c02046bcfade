#pragma once

#include <array>

#include "generators/prescribe.hpp"

namespace ccdfuzz {

inline constexpr std::array kFeatures = {Feature::kFace, Feature::kEdge, Feature::kCorner};

/// The parameters u, v of barycentric coordinates.
inline Uv<Dyadic> dyadic_uv(const Barycentric& x) {
  return {x[0], x[1]};
}

}  // namespace ccdfuzz
