#include "hunt/hunt.hpp"

#include <gtest/gtest.h>

#include <atomic>

#include "eval/cpu_time.hpp"
#include "scratch_folder.hpp"

namespace ccdfuzz {
namespace {

// Within 2^±6 most draws are thrown away. They count as the time of draws, so that mutants still
// have their half: without that, making them took 95 % of the time.
TEST(Hunt, MakingDrawsLeavesMutantsTheirHalf) {
  const ScratchFolder folder;
  Store store = Store::open(folder.path()).value();
  HuntOptions options;
  options.methods = {"tdibm-c"};
  options.seconds = 1;
  options.ground.scale = 6;
  options.ground.shapes = {Shape::curve(1), Shape::curve(1)};
  const std::atomic<bool> stop = false;
  const double start = thread_cpu_seconds();
  const HuntReport report = hunt(
      options, store, [](const HuntProgress&) {}, stop);
  const double all = thread_cpu_seconds() - start;
  EXPECT_LT(report.draw_cpu_seconds, 0.7 * all);
  EXPECT_GT(report.cases, 0U);
}

}  // namespace
}  // namespace ccdfuzz
