// What adapters of codes with doubles share that are asked about what is far from the origin.
#pragma once

#include <algorithm>

#include "../plugins/adapter.hpp"

namespace adapter {

/// The length that such a code loses by rounding: that of two positions and a way, along three
/// axes.
inline double lost_length(const ccd::Query& query) {
  double farthest = 0;
  for (const int side : {0, 1}) {
    const ccd::Patch patch = query.patch(side);
    for (std::size_t i = 0; i < patch.count(); ++i) {
      for (int k = 0; k < 3; ++k) {
        for (const double t : {0., query.t_max()}) {
          farthest = std::max(farthest, std::abs(patch.at(i, k, t)));
        }
      }
    }
  }
  return 3 * std::sqrt(3) * 0x1p-53 * farthest;
}

}  // namespace adapter
