#include "ccd/projection.hpp"

#include <gtest/gtest.h>

namespace ccdfuzz {
namespace {

TEST(Projection, BoundsGrowWithPatchAndAxis) {
  const LargestComponents unit_extent{1, 2};
  const Axis first{{1, 0, 0}, 0}, last{{1, 0, 0}, 5};
  const CoefficientError at_first = coefficient_error(Shape::triangle(2), unit_extent, first);
  const CoefficientError at_last = coefficient_error(Shape::triangle(2), unit_extent, last);
  // 2·B·k·eps with B = 3·2²·2^stage and k = 12 + 2·stage + 3.
  EXPECT_EQ(at_first.intercept, 2 * 12 * 15 * 0x1p-52);
  EXPECT_EQ(at_last.intercept, 2 * 384 * 25 * 0x1p-52);
  EXPECT_EQ(at_first.slope, 2 * at_first.intercept);
}

}  // namespace
}  // namespace ccdfuzz
