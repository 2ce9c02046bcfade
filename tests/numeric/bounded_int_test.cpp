#include "numeric/bounded_int.hpp"

#include <cstdint>

#include <gtest/gtest.h>

namespace ccdfuzz {
namespace {

using Int = BoundedInt<1024>;

TEST(BoundedInt, ThrowsWhatDoesNotFit) {
  const Int top = Int(1) << 1023;
  EXPECT_EQ((top - Int(1) + top).limbs(), 16);
  EXPECT_THROW(top + top, InternalError);
  EXPECT_THROW(top << 1, InternalError);
  EXPECT_THROW((Int(1) << 512) * (Int(1) << 512), InternalError);
}

}  // namespace
}  // namespace ccdfuzz
