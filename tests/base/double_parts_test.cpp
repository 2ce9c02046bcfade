#include "base/double_parts.hpp"

#include <array>
#include <cmath>
#include <limits>

#include "rapidcheck.hpp"

namespace ccdfuzz {
namespace {

RC_GTEST_PROP(DoubleParts, AreAssembledFromAnyMantissa, ()) {
  const auto mantissa =
      *rc::gen::inRange<std::int64_t>(-(std::int64_t{1} << 53), (std::int64_t{1} << 53) + 1);
  const int shift = *rc::gen::inRange(0, 54), exponent = *rc::gen::inRange(-1074, 970);
  const std::int64_t whole = mantissa >> shift << shift;  // the lowest bits are 0
  RC_ASSERT(double_of(whole, exponent - shift) ==
            std::ldexp(static_cast<double>(whole), exponent - shift));
}

TEST(DoubleParts, CompareLikeReals) {
  constexpr double kTiniest = 0x1p-1074, kInfinity = std::numeric_limits<double>::infinity();
  constexpr std::array kAscending = {-kInfinity, -1.0,      -kTiniest, 0.0,
                                     kTiniest,   0x1p-1022, 1.0,       kInfinity};
  for (size_t i = 0; i < kAscending.size(); ++i) {
    for (size_t j = 0; j < kAscending.size(); ++j) {
      EXPECT_EQ(compare(kAscending[i], kAscending[j]), i <=> j) << i << ' ' << j;
    }
  }
  EXPECT_EQ(compare(-0.0, 0.0), 0 <=> 0);
  EXPECT_FALSE(is_finite(kInfinity) || is_nan(kInfinity));
  EXPECT_FALSE(is_finite(-std::numeric_limits<double>::quiet_NaN()));
  EXPECT_TRUE(is_nan(-std::numeric_limits<double>::quiet_NaN()));
  EXPECT_TRUE(is_finite(std::numeric_limits<double>::max()));
}

TEST(DoubleParts, AreRightAtTheEndsOfTheRange) {
  EXPECT_EQ(parts_of(0.0), (DoubleParts{0, 0}));
  EXPECT_EQ(parts_of(-0.0), (DoubleParts{0, 0}));
  EXPECT_EQ(parts_of(0x1p-1074), (DoubleParts{1, -1074}));
  EXPECT_EQ(parts_of(-0x1p-1022), (DoubleParts{-1, -1022}));
  EXPECT_EQ(parts_of(0x1.fffffffffffffp1023), (DoubleParts{(std::int64_t{1} << 53) - 1, 971}));
}

}  // namespace
}  // namespace ccdfuzz
