#include "numeric/fp_guard.hpp"

#include <gtest/gtest.h>

#include <cfenv>
#if defined(__SSE2__)
#include <immintrin.h>
#endif

namespace ccdfuzz {
namespace {

TEST(FpGuard, RestoresWhatTheHostHadSet) {
  std::fesetround(FE_UPWARD);
  EXPECT_FALSE(fp_environment_is_sound());
  {
    const FpGuard guard;
    EXPECT_TRUE(fp_environment_is_sound());
  }
  EXPECT_EQ(std::fegetround(), FE_UPWARD);
  std::fesetround(FE_TONEAREST);
}

#if defined(__SSE2__)
TEST(FpGuard, KeepsSubnormalsUnderAHostThatFlushesThem) {
  const unsigned before = _mm_getcsr();
  _mm_setcsr(before | 0x8040);
  EXPECT_FALSE(fp_environment_is_sound());
  {
    const FpGuard guard;
    EXPECT_TRUE(fp_environment_is_sound());
  }
  EXPECT_EQ(_mm_getcsr() & 0x8040U, 0x8040U);
  _mm_setcsr(before);
}
#endif

}  // namespace
}  // namespace ccdfuzz
