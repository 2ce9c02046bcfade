#include "numeric/bounded_int.hpp"

#include <cstdint>

#include <gtest/gtest.h>

namespace ccdfuzz {
namespace {

using Int = BoundedInt<1024>;

Integer to_integer(const Int& x) {
  Integer r = 0;
  for (int i = x.limbs(); i-- > 0;) {
    r <<= 64;
    r += Integer(static_cast<unsigned long>(x.limb(i)));
  }
  return x.sign() < 0 ? Integer(-r) : r;
}

TEST(BoundedInt, ThrowsWhatDoesNotFit) {
  const Int top = Int(1) << 1023;
  EXPECT_EQ(to_integer(top - Int(1) + top), (Integer(1) << 1024) - 1);
  EXPECT_THROW(top + top, InternalError);
  EXPECT_THROW(top << 1, InternalError);
  EXPECT_THROW((Int(1) << 512) * (Int(1) << 512), InternalError);
}

}  // namespace
}  // namespace ccdfuzz
