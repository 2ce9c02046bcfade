#include "hunt/scheduler.hpp"
#include "base/cpu_time.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <deque>
#include <vector>

namespace ccdfuzz {
namespace {

/// What one turn of each cell costs on a fake clock: five orders of magnitude apart.
const std::vector<double> kCosts = {1e-5, 1e-4, 3e-3, 0.05, 1.0};

TEST(Scheduler, EveryCellGetsTheSameTimeUpToOneTurn) {
  Scheduler scheduler(kCosts.size());
  std::vector<std::uint64_t> turns(kCosts.size());
  double total = 0;
  while (total < 50) {
    const size_t cell = scheduler.begin();
    scheduler.end(cell, kCosts[cell]);
    ++turns[cell];
    total += kCosts[cell];
  }
  double least = scheduler.used(0), most = scheduler.used(0);
  for (size_t c = 1; c < kCosts.size(); ++c) {
    least = std::min(least, scheduler.used(c));
    most = std::max(most, scheduler.used(c));
  }
  // The cell that leads was last chosen when it had least, and has had one turn since.
  EXPECT_LE(most - least, kCosts.back() * (1 + 1e-9));
  EXPECT_GT(turns[0], 100'000U);
  EXPECT_GE(turns.back(), 9U);
}

TEST(Scheduler, OverlappingTurnsSpreadOverTheCells) {
  // Four turns in flight at once, each ending in the order it began.
  constexpr size_t kInFlight = 4;
  Scheduler scheduler(kCosts.size());
  std::deque<size_t> running;
  double total = 0;
  while (total < 200) {
    while (running.size() < kInFlight) running.push_back(scheduler.begin());
    const size_t cell = running.front();
    running.pop_front();
    scheduler.end(cell, kCosts[cell]);
    total += kCosts[cell];
  }
  for (size_t c = 0; c < kCosts.size(); ++c) {
    EXPECT_NEAR(scheduler.used(c), total / static_cast<double>(kCosts.size()),
                kInFlight * kCosts.back())
        << "cell " << c;
  }
}

TEST(Scheduler, TheFirstRoundVisitsEveryCellOnceInOrder) {
  Scheduler scheduler(6);
  for (size_t c = 0; c < 6; ++c) EXPECT_EQ(scheduler.begin(), c);
  EXPECT_EQ(scheduler.begin(), 0U);
}

TEST(Scheduler, ACellWhoseTurnsCostNothingDoesNotHangTheRest) {
  Scheduler scheduler(2);
  // A clock too coarse to see the turn: the tie must not go to the same cell for ever.
  size_t visits_of_1 = 0;
  for (int i = 0; i < 100; ++i) {
    const size_t cell = scheduler.begin();
    visits_of_1 += cell;
    scheduler.end(cell, 0);
  }
  EXPECT_GT(visits_of_1, 0U);
}

TEST(ThreadClock, AdvancesOnlyWithWorkOfThisThread) {
  const double before = thread_cpu_seconds();
  volatile unsigned sink = 0;
  while (thread_cpu_seconds() == before) sink = sink + 1;
  EXPECT_GT(thread_cpu_seconds(), before);
}

}  // namespace
}  // namespace ccdfuzz
