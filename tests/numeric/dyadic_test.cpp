#include "numeric/dyadic.hpp"

#include <gtest/gtest.h>

namespace ccdfuzz {
namespace {

TEST(Dyadic, RefusesWhatIsNotADouble) {
  EXPECT_FALSE(Dyadic(1, -1075).to_double_exactly());
  EXPECT_FALSE(Dyadic(1, 1024).to_double_exactly());
  EXPECT_FALSE((Dyadic(1, 53) + Dyadic(1)).to_double_exactly());
  EXPECT_FALSE(Dyadic::from(Rational(1, 3)));
}

}  // namespace
}  // namespace ccdfuzz
