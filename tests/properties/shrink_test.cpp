#include "properties/shrink.hpp"

#include <gmock/gmock.h>

#include <algorithm>

#include "properties/suites.hpp"
#include "rapidcheck.hpp"

namespace ccdfuzz {
namespace {

constexpr std::uint64_t kTries = 10'000;

TEST(Shrink, FindsTheLeastThatKeepsAProperty) {
  const ChoiceNumbers start = {7, 0, 999, 12, 40'000, 3};
  const auto has_a_large_one = [](const ChoiceNumbers& numbers) {
    return std::ranges::any_of(numbers, [](std::uint64_t x) { return x >= 100; });
  };
  EXPECT_THAT(shrunk(start, kTries, has_a_large_one), testing::ElementsAre(100));
  const auto sums_high = [](const ChoiceNumbers& numbers) {
    std::uint64_t sum = 0;
    for (const std::uint64_t x : numbers) sum += x;
    return sum >= 1000;
  };
  EXPECT_THAT(shrunk(start, kTries, sums_high), testing::ElementsAre(1000));
  EXPECT_THAT(shrunk(start, kTries, [](const ChoiceNumbers&) { return true; }), testing::IsEmpty());
}

TEST(Shrink, StripsLowBitsWhereTheyDoNotMatter) {
  const auto is_large = [](const ChoiceNumbers& numbers) {
    return !numbers.empty() && numbers[0] >> 40 != 0;
  };
  EXPECT_THAT(shrunk({0x1'2345'6789'abcdU}, kTries, is_large),
              testing::ElementsAre(std::uint64_t{1} << 40));
}

RC_GTEST_PROP(Shrink, EveryStepIsSimplerOrDroppedAndTheResultStillShowsIt,
              (ChoiceNumbers numbers, std::uint64_t least)) {
  const auto keeps = [&](const ChoiceNumbers& x) {
    return std::ranges::any_of(x, [&](std::uint64_t y) { return y % 1000 >= least % 1000; });
  };
  RC_PRE(keeps(numbers));
  std::uint64_t calls = 0;
  const ChoiceNumbers result = shrunk(numbers, 500, [&](const ChoiceNumbers& x) {
    ++calls;
    return keeps(x);
  });
  RC_ASSERT(keeps(result));
  RC_ASSERT(!simpler(numbers, result));
  RC_ASSERT(calls <= 500U);
  RC_ASSERT(shrunk(numbers, 500, keeps) == result);
}

RC_GTEST_PROP(Shrink, EveryStepIsSimpler, (ChoiceNumbers numbers, std::uint64_t taken)) {
  ChoiceShrinker shrinker(numbers);
  for (int i = 0; i < 200; ++i) {
    const auto step = shrinker.next();
    if (!step) break;
    RC_ASSERT(simpler(*step, shrinker.numbers()));
    if (taken >> (i % 64) & 1) shrinker.take(*step);
  }
}

TEST(Shrink, ACounterexampleOfAClaimFailsAgain) {
  const Property property = *property_named("tdibm.no_false_negative");
  const auto runner = [&](const ChoiceNumbers& numbers) -> InputRun {
    Draw choices = Draw::from_numbers(numbers);
    return {run(property, choices), "", choices.numbers()};
  };
  for (std::uint64_t i = 0;; ++i) {
    Draw random = Draw::mostly_small(Random::keyed({3, i}));
    if (run(property, random).status != Check::Status::kFails) continue;
    const auto found = shrunk_counterexample(runner, random.numbers(), {300});
    ASSERT_TRUE(found);
    EXPECT_FALSE(simpler(random.numbers(), found->numbers));
    const Check again = runner(found->numbers).check;
    EXPECT_EQ(again.status, Check::Status::kFails);
    EXPECT_EQ(again.text, found->check.text);
    return;
  }
}

}  // namespace
}  // namespace ccdfuzz
