#include "property_turns.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/process.hpp"
#include "properties/suites.hpp"

namespace ccdfuzz {
namespace {

using testing::StartsWith;

TEST(PropertyTurns, NameTheCommandThatFindsTheSame) {
  Property known = *property_named("tdibm.separation");
  ASSERT_EQ(known.expected, Expectation::kFails);
  known.expected = Expectation::kHolds;
  PropertyTurns turns({known}, 7);
  std::string found;
  for (int i = 0; i < 100'000 && found.empty(); ++i) found = turns();
  ASSERT_THAT(found, StartsWith("ccdfuzz check tdibm.separation --seed 7 --first "));
  const std::size_t colon = found.find(": ");
  const Finished checked = shell("$" + found.substr(0, colon) + " --json");
  EXPECT_EQ(checked.code, 0) << checked.err;
  const auto rows = json_lines(checked.out);
  ASSERT_EQ(rows.size(), 1);
  EXPECT_EQ(rows[0].at("checked"), 1);
  EXPECT_EQ(rows[0].at("failure"), found.substr(colon + 2));
}

}  // namespace
}  // namespace ccdfuzz
