#pragma once

#include <cmath>

#include "case/query.hpp"

namespace ccdfuzz {

/// True iff every coordinate and velocity of a query, t_max and the separation is 0 or of a
/// magnitude in [2^-bits, 2^bits]: where bits are few, neither under- nor overflow explains a
/// failure.
inline bool is_within_scale(const Query& query, int bits) {
  const double least = std::ldexp(1.0, -bits), most = std::ldexp(1.0, bits);
  const auto fits = [&](double x) {
    return x == 0 || (std::abs(x) >= least && std::abs(x) <= most);
  };
  bool all_fit = fits(query.t_max) && fits(query.separation);
  for (const MovingPatch<double>& patch : query.patches) {
    for_each_coordinate(patch, [&](double x) { all_fit = all_fit && fits(x); });
  }
  return all_fit;
}

}  // namespace ccdfuzz
