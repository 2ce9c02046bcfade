#include "numeric/double_parts.hpp"

#include <cmath>

#include "rapidcheck.hpp"

namespace ccdfuzz {
namespace {

RC_GTEST_PROP(DoubleParts, MultiplyBackToTheDouble, ()) {
  const auto bits = *rc::gen::arbitrary<std::uint64_t>() * 0x9e3779b97f4a7c15ULL;
  const bool subnormal = *rc::gen::inRange(0, 4) == 0;
  const double x = std::bit_cast<double>(subnormal ? bits & 0x800f'ffff'ffff'ffffULL : bits);
  RC_PRE(std::isfinite(x) && x != 0);
  const DoubleParts parts = parts_of(x);
  RC_ASSERT(std::ldexp(static_cast<double>(parts.mantissa), parts.exponent) == x);
  RC_ASSERT(parts.mantissa % 2 != 0);
  int exponent = 0;
  std::frexp(x, &exponent);
  RC_ASSERT(parts.top() == exponent);
}

TEST(DoubleParts, OfTheEndsOfTheRange) {
  EXPECT_EQ(parts_of(0.0), (DoubleParts{0, 0}));
  EXPECT_EQ(parts_of(-0.0), (DoubleParts{0, 0}));
  EXPECT_EQ(parts_of(0x1p-1074), (DoubleParts{1, -1074}));
  EXPECT_EQ(parts_of(-0x1p-1022), (DoubleParts{-1, -1022}));
  EXPECT_EQ(parts_of(0x1.fffffffffffffp1023), (DoubleParts{(std::int64_t{1} << 53) - 1, 971}));
}

}  // namespace
}  // namespace ccdfuzz
