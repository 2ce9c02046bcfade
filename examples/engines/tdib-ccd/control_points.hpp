// Control points as TDIB-CCD has them.
#pragma once

#include "../../plugins/adapter.hpp"

/// The control points of its triangles come by rising power of v, and within it of u.
template <class Patch>
void fill(Patch& out, const ccdfuzz_patch& raw, const double (*points)[3]) {
  const std::size_t n = raw.degree_u;
  const bool is_triangle = raw.shape == CCDFUZZ_TRIANGLE;
  for (std::size_t i = 0, from = 0; i <= n; ++i) {
    for (std::size_t j = 0; j <= (is_triangle ? n - i : n); ++j, ++from) {
      auto& point = out.ctrlp[is_triangle ? j * (2 * n + 3 - j) / 2 + i : from];
      const double weight = raw.weights != nullptr ? raw.weights[from] : 1;
      for (int k = 0; k < 3; ++k) point[k] = weight * points[from][k];
      if constexpr (std::decay_t<decltype(point)>::RowsAtCompileTime == 4) point[3] = weight;
    }
  }
}
