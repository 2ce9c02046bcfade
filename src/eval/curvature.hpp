#pragma once

#include <optional>

#include "bezier/patch.hpp"
#include "numeric/rational.hpp"

namespace ccdfuzz {

/// The root mean square of the principal curvatures of a patch at (u, v) and time t, in 1/length,
/// as in Fig. 5. nullopt for points and curves, and where dS/du and dS/dv are parallel. Derivatives
/// are exact, and all after them is rounded.
std::optional<double> rms_curvature(const MovingPatch<double>& patch, const Uv<Rational>& uv,
                                    const Rational& t);

}  // namespace ccdfuzz
