#include "hunt/schedule.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <deque>
#include <map>
#include <set>
#include <vector>

namespace ccdfuzz {
namespace {

/// What one turn of each cell costs on a fake clock: five orders of magnitude apart.
const std::vector<double> kCosts = {1e-5, 1e-4, 3e-3, 0.05, 1.0};

TEST(Schedule, EveryCellGetsTheSameTimeUpToOneTurn) {
  Schedule schedule(kCosts.size());
  std::vector<std::uint64_t> turns(kCosts.size());
  double total = 0;
  while (total < 50) {
    const Turn turn = *schedule.next();
    schedule.done(turn, kCosts[turn.cell]);
    ++turns[turn.cell];
    total += kCosts[turn.cell];
  }
  double least = schedule.used(0), most = schedule.used(0);
  for (size_t c = 1; c < kCosts.size(); ++c) {
    least = std::min(least, schedule.used(c));
    most = std::max(most, schedule.used(c));
  }
  // The cell that leads was last chosen when it had least, and has had one turn since.
  EXPECT_LE(most - least, kCosts.back() * (1 + 1e-9));
  EXPECT_GT(turns[0], 100'000U);
  EXPECT_GE(turns.back(), 9U);
}

TEST(Schedule, OverlappingTurnsSpreadOverTheCells) {
  // Four turns in flight at once, each ending in the order it began.
  constexpr size_t kInFlight = 4;
  Schedule schedule(kCosts.size());
  std::deque<Turn> running;
  double total = 0;
  while (total < 200) {
    while (running.size() < kInFlight) running.push_back(*schedule.next());
    const Turn turn = running.front();
    running.pop_front();
    schedule.done(turn, kCosts[turn.cell]);
    total += kCosts[turn.cell];
  }
  for (size_t c = 0; c < kCosts.size(); ++c) {
    EXPECT_NEAR(schedule.used(c), total / static_cast<double>(kCosts.size()),
                kInFlight * kCosts.back())
        << "cell " << c;
  }
}

TEST(Schedule, TheFirstRoundVisitsEveryCellOnceFromTheLast) {
  Schedule schedule(6);
  for (size_t c = 6; c-- > 0;) EXPECT_EQ(schedule.next()->cell, c);
  EXPECT_EQ(schedule.next()->cell, 5U);
}

TEST(Schedule, ACellWhoseTurnsCostNothingDoesNotHangTheRest) {
  Schedule schedule(2);
  // A clock too coarse to see the turn: the tie must not go to the same cell for ever.
  std::set<size_t> visited;
  for (int i = 0; i < 100; ++i) {
    const Turn turn = *schedule.next();
    visited.insert(turn.cell);
    schedule.done(turn, 0);
  }
  EXPECT_EQ(visited.size(), 2U);
}

TEST(Schedule, BreedingTakesHalfTheTimeOfACellAndOneThread) {
  Schedule schedule(1);
  std::map<Turn::What, double> used;
  for (int i = 0; i < 1000; ++i) {
    const Turn turn = *schedule.next();
    const double seconds = turn.what == Turn::What::kDraw ? 3 : 1;
    // Another thread meanwhile.
    const Turn other = *schedule.next();
    EXPECT_FALSE(turn.what == Turn::What::kBreed && other.what == Turn::What::kBreed);
    schedule.done(turn, seconds);
    schedule.done(other, 0);
    used[turn.what] += seconds;
  }
  EXPECT_NEAR(used[Turn::What::kBreed], used[Turn::What::kDraw], 3.0);
}

TEST(Schedule, APopulationOfNothingLeavesTheTimeToDraws) {
  Schedule schedule(1);
  std::uint64_t draws = 0;
  for (int i = 0; i < 1000; ++i) {
    const Turn turn = *schedule.next();
    draws += turn.what == Turn::What::kDraw ? 1 : 0;
    schedule.done(turn, turn.what == Turn::What::kDraw ? 1 : 1e-6, false);
  }
  EXPECT_EQ(draws, 500U) << "each breeding turn waits for a further draw";
}

TEST(Schedule, GivesEveryDrawAndThenOneBreedingTurnOfEachCellWhenItCountsDraws) {
  constexpr std::uint64_t kDraws = 5;
  Schedule schedule(3, kDraws);
  std::map<size_t, std::vector<std::uint64_t>> drawn;
  std::set<size_t> bred;
  double share = 0;
  while (const std::optional<Turn> turn = schedule.next()) {
    if (turn->what == Turn::What::kDraw) {
      EXPECT_TRUE(bred.empty());
      drawn[turn->cell].push_back(turn->draw);
    } else {
      EXPECT_EQ(turn->draw, kDraws);
      EXPECT_TRUE(bred.insert(turn->cell).second);
    }
    schedule.done(*turn, 1);
    EXPECT_GT(schedule.share_done(), share);
    share = schedule.share_done();
  }
  EXPECT_EQ(share, 1);
  EXPECT_EQ(bred.size(), 3U);
  for (const auto& [cell, draws] : drawn) {
    EXPECT_EQ(draws, (std::vector<std::uint64_t>{0, 1, 2, 3, 4})) << cell;
  }
}

}  // namespace
}  // namespace ccdfuzz
