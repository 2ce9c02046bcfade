#include "fuzz/mutator/mutate_query.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <bit>
#include <limits>

#include "base/verify.hpp"
#include "case/scale.hpp"
#include "meeting_points.hpp"

namespace ccdfuzz {
namespace {

TEST(MutateQuery, KeepsNumbersThatGrowWithinTheRangeOfFloats) {
  constexpr auto kMost = static_cast<double>(std::numeric_limits<float>::max());
  Query query;
  query.patches[0] = {Shape::hull(2), {{kMost, 0, -kMost}, {-kMost, kMost, 1}}, {{kMost, 0, 0}}};
  query.patches[1] = {Shape::hull(1), {{0, -kMost, kMost}}, {{-kMost, 0, kMost}}, {}, {}, kMost};
  for (std::uint64_t seed = 0; seed < 20'000; ++seed) {
    Draw draw(Random::keyed({seed}));
    const Query mutant = mutate_query(query, query, draw);
    ASSERT_TRUE(is_valid(mutant)) << "seed " << seed;
    ASSERT_TRUE(is_binary32(mutant)) << "seed " << seed;
  }
}

// Two compilers evaluate arguments in other orders, and no draw may depend on that.
TEST(MutateQuery, MakesTheSameMutantsEverywhere) {
  Query query;
  query.patches[0] = {Shape::hull(2), {{0, 0, 1}, {1, 0, 2}}, {{0, 0, -2}}, {}, {}, 0.5};
  query.patches[1] = {Shape::hull(3), {{0, 0, 0}, {0, 1, 0}, {1, 0, 0}}, {{0, 0, 0}}};
  query.t_max = 1;
  std::uint64_t hash = 0xcbf29ce484222325;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    Draw draw(Random::keyed({seed}));
    Query mutant = mutate_query(query, query, draw);
    for (MovingPatch<double>& patch : mutant.patches) {
      for_each_coordinate(patch, [&](double x) {
        hash = (hash ^ std::bit_cast<std::uint64_t>(x)) * 0x100000001b3;
      });
    }
  }
  EXPECT_EQ(hash, 0xe527ec1065150747u) << fmt::format("{:#x}", hash);
}

TEST(MutateQuery, KeepsTheShapesOfLinearPatches) {
  const Query query = falling_vertex();
  int changed = 0;
  for (std::uint64_t seed = 0; seed < 2'000; ++seed) {
    Draw draw(Random::keyed({seed}));
    const Query mutant = mutate_query(query, query, draw);
    ASSERT_TRUE(is_valid(mutant) && is_binary32(mutant)) << "seed " << seed;
    const size_t triangle = mutant.patches[0].positions.size() == 3 ? 0 : 1;
    EXPECT_EQ(mutant.patches[triangle].shape, Shape::triangle(1));
    EXPECT_EQ(mutant.patches[1 - triangle].shape, Shape::point());
    changed += mutant == query ? 0 : 1;
  }
  EXPECT_GT(changed, 1'500);
}

}  // namespace
}  // namespace ccdfuzz
