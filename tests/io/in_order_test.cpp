#include "io/in_order.hpp"

#include <gtest/gtest.h>

#include <stdexcept>
#include <thread>
#include <vector>

namespace ccdfuzz {
namespace {

/// Burns a time that varies wildly with the index, so that results are ready out of order.
size_t uneven_square(size_t i) {
  volatile size_t sink = 0;
  for (size_t k = 0; k < (i * 7919) % 5000; ++k) sink = sink + k;
  return i * i;
}

TEST(RunInOrder, SinkSeesEveryResultInOrderForAnyNumberOfThreads) {
  for (const int threads : {1, 2, 3, 8}) {
    std::vector<size_t> seen;
    const size_t done = run_in_order<size_t>(1000, threads, uneven_square,
                                             [&](size_t result) { seen.push_back(result); });
    EXPECT_EQ(done, 1000U);
    ASSERT_EQ(seen.size(), 1000U) << threads << " threads";
    for (size_t i = 0; i < seen.size(); ++i) ASSERT_EQ(seen[i], i * i) << threads << " threads";
  }
}

TEST(RunInOrder, NothingToDoIsDone) {
  EXPECT_EQ(run_in_order<int>(
                0, 2, [](size_t) { return 1; }, [](int) { FAIL(); }),
            0U);
}

TEST(RunInOrder, StopKeepsAPrefix) {
  std::atomic<bool> stop = false;
  std::vector<size_t> seen;
  const size_t done = run_in_order<size_t>(
      100'000, 2, uneven_square,
      [&](size_t result) {
        seen.push_back(result);
        if (seen.size() == 10) stop = true;
      },
      &stop);
  EXPECT_EQ(done, seen.size());
  EXPECT_GE(seen.size(), 10U);
  EXPECT_LT(seen.size(), 1000U);
  for (size_t i = 0; i < seen.size(); ++i) EXPECT_EQ(seen[i], i * i);
}

TEST(RunInOrder, AnExceptionOfWorkOrSinkReachesTheCaller) {
  const auto fail_at_5 = [](size_t i) -> size_t {
    if (i == 5) throw std::runtime_error("five");
    return i;
  };
  EXPECT_THROW(run_in_order<size_t>(100, 2, fail_at_5, [](size_t) {}), std::runtime_error);
  EXPECT_THROW(
      run_in_order<size_t>(
          100, 2, [](size_t i) { return i; }, [](size_t) { throw std::runtime_error("sink"); }),
      std::runtime_error);
}

TEST(RunInOrder, WorkHearsThatOtherWorkThrew) {
  std::atomic<int> begun = 0;
  const auto one_waits = [&](size_t i) {
    if (++begun; i == 0) {
      while (begun < 2) std::this_thread::yield();
      throw std::runtime_error("zero");
    }
    while (!is_in_vain()) std::this_thread::yield();
    return i;
  };
  EXPECT_THROW(run_in_order<size_t>(2, 2, one_waits, [](size_t) {}), std::runtime_error);
}

}  // namespace
}  // namespace ccdfuzz
