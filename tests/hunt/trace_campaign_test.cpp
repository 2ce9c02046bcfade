#include "hunt/trace_campaign.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "certify/checker/check_truth.hpp"
#include "hunt/traced_cases.hpp"

namespace ccdfuzz {
namespace {

double largest(const Query& query, const Points<double> MovingPatch<double>::*points) {
  double most = 0;
  for (const MovingPatch<double>& patch : query.patches) {
    for (const Vec3<double>& p : patch.*points) {
      for (int k = 0; k < 3; ++k) most = std::max(most, std::abs(p[k]));
    }
  }
  return most;
}

TEST(TracedCases, HaveAWitnessThatTheCheckerAcceptsAtAllScalesAndFarAway) {
  constexpr std::uint64_t kBlocks = 72;  // each class with each construction twice
  std::set<std::string> generators;
  bool tiny = false, huge = false, late = false;
  double fastest = 0;
  for (std::uint64_t block = 0; block < kBlocks; ++block) {
    const TracedBlock made = traced_block(3, block);
    ASSERT_EQ(made.cases.size(), kTracedBlock);
    for (const Case& known : made.cases) {
      ASSERT_TRUE(known.truth.witness);
      const auto holds = check_truth(known);
      ASSERT_TRUE(holds) << block << ": " << holds.error().message();
      EXPECT_EQ(known.origin.contact, name_of(made.contact));
      generators.insert(known.origin.generator);
      const double size = largest(known.query, &MovingPatch<double>::positions);
      tiny |= size < 0x1p-700;
      huge |= size > 0x1p700;
      late |= known.truth.witness->t < exact(known.query.t_max);
      const double way = largest(known.query, &MovingPatch<double>::velocities) * known.query.t_max;
      if (size > 0 && size < 0x1p900) fastest = std::max(fastest, way / size);
    }
  }
  EXPECT_EQ(generators.size(), 6U);
  EXPECT_TRUE(tiny);
  EXPECT_TRUE(huge);
  EXPECT_TRUE(late);
  EXPECT_GT(fastest, 0x1p25);
}

struct Result {
  std::vector<std::uint64_t> cells;
  std::vector<std::string> lost;
  std::uint64_t cases = 0, broken = 0;
  friend bool operator==(const Result&, const Result&) = default;
};

Result traced(const std::vector<std::string>& methods, std::uint64_t first, std::uint64_t count,
              int threads) {
  Result out;
  const std::atomic<bool> stop = false;
  const TraceReport report = trace_generated(
      {methods, 5, first, count, {.precision = 0x1p-6}, threads},
      [&](const LostWitness& lost) {
        EXPECT_TRUE(lost.trace.lost);
        out.lost.push_back(lost.method + " " + std::to_string(lost.number));
      },
      [](std::uint64_t) {}, stop);
  for (const TraceCell& cell : report.cells) {
    out.cells.insert(out.cells.end(), {cell.traced, cell.lost, cell.margin.value_or(~0ULL)});
  }
  out.cases = report.cases;
  out.broken = report.broken_claims;
  EXPECT_EQ(report.lost, out.lost.size());
  return out;
}

TEST(TraceCampaign, TheSoundMethodsLoseNothingAndThePlainOneDoes) {
  const Result sound = traced({"tdibm-c", "tdibm-rational"}, 0, 960, 2);
  EXPECT_EQ(sound.cases, 960U);
  EXPECT_TRUE(sound.lost.empty()) << sound.lost.front();
  const Result plain = traced({"tdibm"}, 0, 960, 2);
  EXPECT_GT(plain.lost.size(), 50U);
  EXPECT_EQ(plain.broken, 0U) << "it claims nothing";
}

TEST(TraceCampaign, AMethodThatLosesWhatItClaimsToKeepIsCounted) {
  EXPECT_GT(traced({"tdibm-e"}, 0, 3000, 2).broken, 0U) << "its products underflow";
}

TEST(TraceCampaign, DependsOnTheNumbersOfTheCasesAlone) {
  const std::vector<std::string> methods = {"tdibm", "tdibm-c"};
  const Result whole = traced(methods, 7, 200, 1);
  EXPECT_EQ(whole, traced(methods, 7, 200, 3));
  std::vector<std::string> parts = traced(methods, 7, 50, 2).lost;
  const std::vector<std::string> rest = traced(methods, 57, 150, 2).lost;
  parts.insert(parts.end(), rest.begin(), rest.end());
  EXPECT_EQ(whole.lost, parts);
  ASSERT_FALSE(whole.lost.empty());
  const std::string& one = whole.lost.front();
  const size_t space = one.find(' ');
  EXPECT_EQ(traced({one.substr(0, space)}, std::stoull(one.substr(space)), 1, 1).lost,
            std::vector<std::string>{one});
}

TEST(TraceCampaign, EndsEarlyWhenStopped) {
  std::atomic<bool> stop = false;
  const TraceReport report = trace_generated(
      {{"tdibm-c"}, 1, 0, 1000000, {}, 2}, [](const LostWitness&) {},
      [&](std::uint64_t) { stop = true; }, stop);
  EXPECT_GT(report.cases, 0U);
  EXPECT_LT(report.cases, 100000U);
}

}  // namespace
}  // namespace ccdfuzz
