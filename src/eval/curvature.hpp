#pragma once

#include <array>
#include <optional>

#include "bezier/patch.hpp"
#include "numeric/rational.hpp"

namespace ccdfuzz {

/// Principal curvatures of a surface at a point, |kappa[0]| ≥ |kappa[1]|, in 1/length; the sign is
/// that of the normal dS/du × dS/dv.
struct Curvature {
  std::array<double, 2> kappa{};
  /// sqrt((kappa[0]² + kappa[1]²)/2), as in Fig. 5.
  double rms() const;
};

/// The curvature of a patch at (u, v) and time t. nullopt for points and curves, and where dS/du
/// and dS/dv are parallel. Derivatives are exact, and all after them is rounded.
std::optional<Curvature> curvature_at(const MovingPatch<double>& patch, const Uv<Rational>& uv,
                                      const Rational& t);

}  // namespace ccdfuzz
