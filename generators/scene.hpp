#pragma once

#include <array>

#include "generators/quadratic.hpp"

namespace ccdfuzz {

/// The prescribed solution of the query (Step I).
struct PrescribedContact {
  Dyadic t;                      ///< t*
  std::array<Barycentric, 2> x;  ///< where on each patch
};

/// A construction under way: a contact and two moving quadratic patches that make it.
struct Scene {
  PrescribedContact contact;
  std::array<MovingPatch<Dyadic>, 2> patches;
  Vec3<Dyadic> normal;  ///< the contact plane's, from patch 2 to patch 1
};

}  // namespace ccdfuzz
