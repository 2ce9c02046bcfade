#include "numeric/small_dyadic.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "generators/draw/draw.hpp"
#include "share.hpp"

namespace ccdfuzz {
namespace {

double any_double(Draw& random) {
  const auto bits = static_cast<int>(random.below(54));
  const auto m = static_cast<double>(random.choose(~std::uint64_t{0}) >> (63 - bits) >> 1);
  const int exponent = static_cast<int>(random.integer(-60, 10));
  return std::ldexp(random.coin() ? m : -m, exponent);
}

TEST(SmallDyadic, IsTheDyadicWhereItFits) {
  Draw random{Random::keyed({11})};
  std::size_t fitting = 0, lost = 0;
  for (std::size_t i = 0; i < 20'000 / kOneIn; ++i) {
    const double start = any_double(random);
    SmallDyadic small = SmallDyadic::exact(start);
    Dyadic exact = Dyadic::exact(start);
    for (int step = 0; step < 4 && small.fits(); ++step) {
      ASSERT_EQ(small.dyadic(), exact);
      ASSERT_EQ(small.sign(), exact.sign());
      const double x = any_double(random);
      switch (random.below(3)) {
        case 0:
          small += SmallDyadic::exact(x);
          exact += Dyadic::exact(x);
          break;
        case 1:
          small -= SmallDyadic::of(Dyadic::exact(x));
          exact -= Dyadic::exact(x);
          break;
        default:
          small *= SmallDyadic::exact(x);
          exact *= Dyadic::exact(x);
          break;
      }
    }
    (small.fits() ? fitting : lost) += 1;
    if (small.fits()) {
      ASSERT_EQ(small.dyadic(), exact);
    } else {
      ASSERT_FALSE((small + SmallDyadic(1)).fits());
      ASSERT_FALSE((SmallDyadic(0) * small).fits());
    }
  }
  EXPECT_GE(fitting, 2000 / kOneIn);
  EXPECT_GE(lost, 1000 / kOneIn);
}

TEST(SmallDyadic, SumsOfLongSumsAreLostBeforeTheyAreWrong) {
  const auto odd = [](int bits) { return Dyadic(Integer((1UL << bits) - 1), 0); };
  const Dyadic p = odd(62) * odd(63), q = (odd(62) * odd(62)).scaled(1);  // 125 bits each
  const SmallDyadic small_q = (SmallDyadic::of(odd(62)) * SmallDyadic::of(odd(62))).scaled(1);
  SmallDyadic small = SmallDyadic::of(odd(62)) * SmallDyadic::of(odd(63));
  Dyadic exact = p;
  for (int step = 0; step < 8 && small.fits(); ++step) {
    ASSERT_EQ(small.dyadic(), exact) << step;
    SmallDyadic next = small_q;
    next += small;
    small = next;
    exact += q;
  }
  EXPECT_FALSE(small.fits());
}

}  // namespace
}  // namespace ccdfuzz
