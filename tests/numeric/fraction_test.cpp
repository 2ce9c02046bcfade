#include "numeric/fraction.hpp"

#include <gtest/gtest.h>

#include "generators/draw/draw.hpp"
#include "share.hpp"

namespace ccdfuzz {
namespace {

/// With a divisor that has a common one with others, or only powers of two, or is 1.
Rational any_rational(Draw& random) {
  const std::int64_t odd = random.coin() ? 1 : random.integer(1, 45);
  Rational out(static_cast<long>(random.integer(-90, 90)), static_cast<unsigned long>(odd));
  out.canonicalize();
  return out * random.dyadic(53, static_cast<long>(random.integer(-90, 40))).rational();
}

TEST(Fraction, IsTheRationalInLowestTerms) {
  Draw random{Random::keyed({12})};
  for (std::size_t i = 0; i < 4'000 / kOneIn; ++i) {
    Rational exact = any_rational(random);
    Fraction x = exact;
    for (int step = 0; step < 6; ++step) {
      ASSERT_EQ(x.rational(), exact);
      ASSERT_EQ(x, Fraction(exact));  // the terms of equal numbers are equal
      ASSERT_EQ(x.sign(), sgn(exact));
      const Rational other = any_rational(random);
      ASSERT_EQ(x < Fraction(other), exact < other);
      if (other > 0) {
        const Rational ratio = exact / other;
        Integer floor;
        mpz_fdiv_q(floor.get_mpz_t(), ratio.get_num_mpz_t(), ratio.get_den_mpz_t());
        ASSERT_EQ(floor_of_ratio(x, other), floor) << exact << " / " << other;
      }
      switch (random.below(4)) {
        case 0:
          x += other;
          exact += other;
          break;
        case 1:
          x = x - other;
          exact -= other;
          break;
        case 2:
          x = x * other;
          exact *= other;
          break;
        default:
          if (other == 0) break;
          x = x / other;
          exact /= other;
          break;
      }
    }
  }
}

}  // namespace
}  // namespace ccdfuzz
