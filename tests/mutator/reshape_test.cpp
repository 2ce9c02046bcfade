#include "fuzz/mutator/reshape.hpp"
#include "bezier/exact_patch.hpp"

#include <gtest/gtest.h>

#include "bases.hpp"
#include "bezier/blossom.hpp"
#include "files/case_json.hpp"

namespace ccdfuzz {
namespace {

/// A point of patch `side` at some parameters that its shape has.
Vec3<Dyadic> point_at(const Contact& q, size_t side, const Uv<Dyadic>& uv) {
  return evaluate<Dyadic>(exact_patch<Dyadic>(q.query.patches[side]), uv, Dyadic(3));
}

Uv<Dyadic> parameters(const Shape& shape) {
  Uv<Dyadic> uv;
  for (size_t k = 0; k < static_cast<size_t>(shape.parameter_count()); ++k) {
    uv[k] = Dyadic(Integer(k == 0 ? 1 : 3), -3);
  }
  return uv;
}

TEST(Reshape, ElevationKeepsEveryPoint) {
  int elevated = 0;
  for (const Contact& base : mutation_bases()) {
    for (int side = 0; side < 2; ++side) {
      for (const bool in_v : {false, true}) {
        Contact q = base;
        if (!elevate_patch(q, side, in_v)) continue;
        ++elevated;
        const size_t s = static_cast<size_t>(side);
        const Uv<Dyadic> uv = parameters(base.query.patches[s].shape);
        EXPECT_EQ(point_at(q, s, uv), point_at(base, s, uv)) << to_json(case_of(base));
      }
    }
  }
  EXPECT_GE(elevated, 20);
}

}  // namespace
}  // namespace ccdfuzz
