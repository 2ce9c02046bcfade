#pragma once

#include <array>

#include "base/result.hpp"
#include "bezier/patch.hpp"

namespace ccdfuzz {

/// A CCD query: do two moving patches touch at some t in the closed [0, t_max], and when first?
/// (Eq. 1). All numbers finite, t_max ≥ 0.
struct Query {
  std::array<MovingPatch<double>, 2> patches;
  double t_max = 1;

  friend bool operator==(const Query&, const Query&) = default;
};

/// Calls visit on each coordinate of a patch: of the positions, point by point, then of the
/// velocities.
template <class Patch, class Visit>
void for_each_coordinate(Patch& patch, const Visit& visit) {
  for (auto* points : {&patch.positions, &patch.velocities}) {
    for (auto& p : *points) {
      for (int k = 0; k < 3; ++k) visit(p[k]);
    }
  }
}

/// Checks shapes, counts, finiteness and t_max; `where` is the path of the query in its file.
/// Errors: the field that is wrong, its value, and what it may be.
Result<void> validate(const Query& query, const std::string& where);

/// True iff validate accepts the query, whatever its bits. Allocates nothing.
bool is_valid(const Query& query);

}  // namespace ccdfuzz
