#include "numeric/rational.hpp"

#include <cmath>
#include <limits>

#include "rapidcheck.hpp"

namespace ccdfuzz {
namespace {

/// A finite double with any bit pattern, subnormals included.
rc::Gen<double> any_finite() {
  return rc::gen::suchThat(
      rc::gen::map(rc::gen::arbitrary<std::uint64_t>(),
                   [](std::uint64_t bits) { return std::bit_cast<double>(bits); }),
      [](double x) { return std::isfinite(x); });
}

RC_GTEST_PROP(Rational, RoundTripsEveryFiniteDouble, ()) {
  const double x = *any_finite();
  const auto back = to_double_exactly(exact(x));
  RC_ASSERT(back.has_value());
  RC_ASSERT(*back == x);
}

RC_GTEST_PROP(Rational, DirectedRoundingEnclosesAndIsTight, ()) {
  const auto bits = *rc::gen::arbitrary<std::pair<std::int64_t, std::int64_t>>();
  RC_PRE(bits.second != 0);
  const long shift = *rc::gen::inRange(-1200L, 1000L);
  Rational x =
      Rational(Integer(static_cast<long>(bits.first)), Integer(static_cast<long>(bits.second)));
  x.canonicalize();
  x *= power_of_two(shift);
  const double down = round_down(x), up = round_up(x);
  if (std::isfinite(down)) RC_ASSERT(exact(down) <= x);
  if (std::isfinite(up)) RC_ASSERT(exact(up) >= x);
  RC_ASSERT(down == up || std::nextafter(down, INFINITY) == up);
  if (down == up) RC_ASSERT(exact(down) == x);
}

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

TEST(Rational, HexTextReadsBack) {
  for (const double x : {0.0, 1.0, -0.1, 0x1p-1074, 0x1.fffffffffffffp1023}) {
    EXPECT_EQ(std::strtod(to_hex(x).c_str(), nullptr), x);
  }
}

}  // namespace
}  // namespace ccdfuzz
