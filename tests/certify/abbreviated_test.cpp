#include "certify/checker/abbreviated.hpp"

#include <gtest/gtest.h>

namespace ccdfuzz {
namespace {

TEST(Abbreviated, SaysAboutWhatALongNumberIsThoughNoDoubleIsNear) {
  EXPECT_EQ(abbreviated(Rational(-1, 3)), "-1/3");
  const Rational third(1, 3);
  EXPECT_EQ(abbreviated(third + power_of_two(-300)).substr(30), "… (about 0.3333333333333333)");
  EXPECT_EQ(abbreviated(-third * power_of_two(3000)).substr(30), "… (about -2^2999)");
  EXPECT_EQ(abbreviated(third * power_of_two(-3000)).substr(30), "… (about 2^-3001)");
}

}  // namespace
}  // namespace ccdfuzz
