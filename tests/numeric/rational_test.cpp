#include "numeric/rational.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace ccdfuzz {
namespace {

TEST(Rational, RoundsAtTheEndsOfTheRange) {
  constexpr double max = std::numeric_limits<double>::max();
  constexpr double tiny = std::numeric_limits<double>::denorm_min();
  EXPECT_EQ(round_down(power_of_two(1024)), max);
  EXPECT_EQ(round_up(power_of_two(1024)), INFINITY);
  EXPECT_EQ(round_up(power_of_two(-1080)), tiny);
  EXPECT_EQ(round_down(power_of_two(-1080)), 0.0);
  EXPECT_EQ(round_down(-power_of_two(-1080)), -tiny);
  EXPECT_FALSE(to_double_exactly(power_of_two(-1075)));
  EXPECT_FALSE(to_double_exactly(power_of_two(1024)));
  EXPECT_FALSE(to_double_exactly(Rational(1, 3)));
}

TEST(Rational, ReadsOnlyCanonicalForms) {
  for (const char* good : {"0", "1", "-1", "1/2", "-7/3", "123456789012345678901234567891/7"}) {
    const auto r = parse_rational(good);
    ASSERT_TRUE(r) << good;
    EXPECT_EQ(to_text(*r), good);
  }
  EXPECT_EQ(to_text(*parse_rational("6/4")), "3/2");
  for (const char* bad : {"", "-", "/", "1/", "/2", "1/0", "1/-2", "+1", "0x1", "1.5", " 1", "1 ",
                          "1/2/3", "1e3", "nan"}) {
    EXPECT_FALSE(parse_rational(bad)) << bad;
  }
}

}  // namespace
}  // namespace ccdfuzz
