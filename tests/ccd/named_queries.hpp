#pragma once

#include "case/query.hpp"

namespace ccdfuzz {

/// Two quadratic triangles that touch transversally at t = 3/4, at (0, 0) of patch 1 and (1/4, 1/4)
/// of patch 2. The first contact is at about 0.742. On the axis z the control points of patch 1
/// make a twin shield: one line that is redundant by 1e-16 hides another that is redundant by much
/// more.
inline Query twin_shield() {
  const auto triangle = [](std::array<std::array<double, 3>, 6> p, std::array<double, 6> vz) {
    MovingPatch<double> patch{Shape::triangle(2), {}, {}};
    for (size_t i = 0; i < 6; ++i) {
      patch.positions.push_back({p[i][0], p[i][1], p[i][2]});
      patch.velocities.push_back({0, 0, vz[i]});
    }
    return patch;
  };
  // Order: w², vw, v², uw, uv, u².
  Query query;
  query.patches[0] =
      triangle({{{0, 0, -1}, {0, 4, -.25}, {0, 8, 0}, {4, 0, -.25}, {4, 4, 0}, {8, 0, 0}}},
               {2, .1 * 3, 0, .3, 0, 0});
  query.patches[1] = triangle({{{-.25, -.25, -7},
                                {-.25, .25, -7},
                                {-.25, .75, -7},
                                {.25, -.25, -7},
                                {.25, .25, -7},
                                {.75, -.25, -7}}},
                              {10, 10, 10, 10, 10, 10});
  query.t_max = 1;
  return query;
}

}  // namespace ccdfuzz
