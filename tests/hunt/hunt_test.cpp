#include "hunted.hpp"

#include <gtest/gtest.h>

#include <cfenv>

#include "files/case_json.hpp"
#include "io/cpu_time.hpp"

namespace ccdfuzz {
namespace {

// Within 2^±6 most draws are thrown away. They count as the time of draws, so that mutants still
// have their half: without that, making them took 95 % of the time.
TEST(Hunt, MakingDrawsLeavesMutantsTheirHalf) {
  HuntOptions options;
  options.methods = {"tdibm-c"};
  options.seconds = 2;
  options.ground.scale = 6;
  options.ground.shapes = {Shape::curve(1), Shape::curve(1)};
  const double start = thread_cpu_seconds();
  const HuntReport report = Hunted(options).report;
  EXPECT_LT(report.draw_cpu_seconds / (thread_cpu_seconds() - start), 0.85);
  EXPECT_GT(asked_of(report).mutants, 0U);
}

// Threads inherit the environment of whoever starts them.
TEST(Hunt, FindsTheSameInAnyFloatingPointEnvironment) {
  const auto hunted = [](int threads) {
    HuntOptions options;
    options.methods = {"tdibm"};
    options.cases = 2;
    options.threads = threads;
    options.seed = 3;
    options.search.max_pops = 2000;
    const std::vector<NamedCase> entries = Hunted(options).store.load().value();
    std::string finds;
    for (const NamedCase& find : entries) finds += to_json(find.value);
    return finds;
  };
  const std::string expected = hunted(1);
  EXPECT_NE(expected, "");
  for (const int rounding : {FE_DOWNWARD, FE_TOWARDZERO}) {
    std::fesetround(rounding);
    const std::string finds = hunted(2);
    std::fesetround(FE_TONEAREST);
    EXPECT_TRUE(finds == expected) << "rounding " << rounding;
  }
}

TEST(Hunt, HasACourseOfAFewHundredSamplesThatShowsBreedingAndItsEnd) {
  HuntOptions options;
  options.methods = {"tdibm", "tdibm-c"};
  options.cases = 100;
  options.ground.linear = true;
  const HuntReport report = Hunted(options).report;
  const auto [queries, mutants] = asked_of(report);
  const std::vector<HuntSample>& course = report.course;
  EXPECT_GE(course.size(), 100U);
  EXPECT_LE(course.size(), 400U);
  EXPECT_EQ(course.back().queries, queries);
  EXPECT_EQ(course.back().mutants, mutants);
  EXPECT_EQ(course.back().finds, report.finds.size());
  EXPECT_EQ(course.back().margins.size(), 2U);
  EXPECT_LT(course[course.size() - report.cells.size() - 1].mutants, mutants);
  const auto seconds = &HuntSample::seconds;
  EXPECT_TRUE(std::ranges::is_sorted(course, {}, seconds));
}

TEST(Hunt, EndsWithTheFirstCounterexampleOfAnOutcome) {
  HuntOptions options;
  options.methods = {"tdibm"};
  options.ground.linear = true;
  options.until = Outcome::kMissed;
  options.seconds = 1e9;  // nothing else ends it
  const HuntReport report = Hunted(options).report;
  EXPECT_TRUE(std::ranges::any_of(
      report.finds, [](const Find& find) { return find.failure.outcome == Outcome::kMissed; }));
}

// Other threads are ahead then: what they did does not count.
TEST(Hunt, ByCasesEndsAtTheSamePlaceOnAnyNumberOfThreads) {
  const auto hunted = [](int threads) {
    HuntOptions options;
    options.methods = {"tdibm", "tdibm-c"};
    options.ground.linear = true;
    options.cases = 100;
    options.until = Outcome::kMissed;
    options.threads = threads;
    const HuntReport report = Hunted(options).report;
    std::vector<std::uint64_t> counts = {report.cases, report.finds.size()};
    for (const HuntCell& cell : report.cells) counts.push_back(cell.tally.n);
    return counts;
  };
  const std::vector<std::uint64_t> expected = hunted(1);
  EXPECT_LT(expected[0], 400U);
  EXPECT_EQ(hunted(3), expected);
}

}  // namespace
}  // namespace ccdfuzz
