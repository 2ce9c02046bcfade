#pragma once

#include "ccd/search.hpp"
#include "ccd/witness_trace/witness_path.hpp"

namespace ccdfuzz {

/// Room for the pairs of one level that contain a witness. At most six cells of a triangle meet in
/// a point, at most four of a tensor patch; and two halves of a window in a time.
inline constexpr size_t kMostOfLevel = 6 * 6 * 2;

/// Calls visit(a, b) for the pairs of children that contain a witness: all of them, or the lowest
/// of each patch alone.
template <class Visit>
void for_each_choice(const WitnessPath& path, const PairParts& parts, bool all,
                     const Visit& visit) {
  for (int a = 0; a < parts.count[0]; ++a) {
    if (!path.in(0, parts.cells[0][static_cast<size_t>(a)])) continue;
    for (int b = 0; b < parts.count[1]; ++b) {
      if (!path.in(1, parts.cells[1][static_cast<size_t>(b)])) continue;
      visit(a, b);
      if (!all) return;
    }
  }
}

}  // namespace ccdfuzz
