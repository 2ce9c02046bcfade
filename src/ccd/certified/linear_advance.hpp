#pragma once

#include <array>
#include <cstdint>

#include "bezier/patch.hpp"
#include "ccd/certified/normalise.hpp"
#include "ccd/exclusion.hpp"

namespace ccdfuzz::certified {

/// What advancing found out. Nothing touches at any t in [0, time); with kClear, in [0, t_max].
struct Advancement {
  enum class Kind : std::uint8_t {
    kClear,    ///< nothing touches (Law A up to t_max)
    kStopped,  ///< at `time` no axis tells the patches apart, or none for a longer time
    kSlow,     ///< not decided: steps become short
  };
  Kind kind = Kind::kSlow;
  double time = 0;  ///< normalised
};

/// The fast path of linear queries (DERIVATION.md, 6). From t = 0 on, an axis that separates the
/// patches at t (Law C) is followed to a time at which it still does. So it did between (Law A),
/// and there the next is chosen. Requires is_linear_pair and FpGuard::holds(). observer: told of
/// each axis that separates at the time reached, and until when.
Advancement advance(const NormalisedQuery& query, ExclusionObserver* observer = nullptr);

/// Parameters of points of both patches that are nearest to each other at the normalised time t, as
/// far as doubles tell. Requires is_linear_pair.
std::array<Uv<double>, 2> nearest_parameters(const NormalisedQuery& query, double t);

}  // namespace ccdfuzz::certified
