#include "numeric/effort.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

namespace ccdfuzz {
namespace {

/// The effort with this in the environment, which is as before afterwards.
Result<std::uint64_t> effort_of(const char* text) {
  const char* const set = std::getenv("CCDFUZZ_EFFORT");
  const std::string before = set == nullptr ? "" : set;
  setenv("CCDFUZZ_EFFORT", text, 1);
  const Result<std::uint64_t> read = effort();
  setenv("CCDFUZZ_EFFORT", before.c_str(), 1);
  return read;
}

TEST(Effort, IsAWholeNumberFrom1ToAMillion) {
  EXPECT_EQ(effort_of(""), 1U);
  EXPECT_EQ(effort_of("1"), 1U);
  EXPECT_EQ(effort_of("1000000"), 1'000'000U);
}

TEST(Effort, AllElseIsRefusedWithTheValueAndTheRange) {
  for (const std::string bad : {"0", "1000001", "-1", "+1", "010", "1.5", "1e3", " 1", "1 ", "none",
                                "99999999999999999999"}) {
    const Result<std::uint64_t> read = effort_of(bad.c_str());
    ASSERT_FALSE(read) << bad;
    EXPECT_EQ(read.error().message(),
              "CCDFUZZ_EFFORT: \"" + bad + "\" is not a whole number from 1 to 1000000");
  }
}

}  // namespace
}  // namespace ccdfuzz
