#include "fuzz/mutator/mutate_bodies.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "base/verify.hpp"
#include "case/scale.hpp"

namespace ccdfuzz {
namespace {

TEST(MutateBodies, KeepsNumbersThatGrowWithinTheRangeOfFloats) {
  constexpr auto kMost = static_cast<double>(std::numeric_limits<float>::max());
  Query query;
  query.patches[0] = {Shape::hull(2), {{kMost, 0, -kMost}, {-kMost, kMost, 1}}, {{kMost, 0, 0}}};
  query.patches[1] = {Shape::hull(1), {{0, -kMost, kMost}}, {{-kMost, 0, kMost}}, {}, {}, kMost};
  for (std::uint64_t seed = 0; seed < 20'000; ++seed) {
    Draw draw(Random::keyed({seed}));
    const Query mutant = mutate_bodies(query, query, draw);
    ASSERT_TRUE(is_valid(mutant)) << "seed " << seed;
    ASSERT_TRUE(is_binary32(mutant)) << "seed " << seed;
  }
}

}  // namespace
}  // namespace ccdfuzz
