#include "run_apart.hpp"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>

#include "planted.hpp"
#include "property_turns.hpp"

namespace ccdfuzz {
namespace {

using testing::EndsWith;
using testing::StartsWith;

using Done = std::function<void(const DriverRun&)>;

Report run_with(const std::function<void(const Done&)>& drive) {
  return run_apart(planted::kNone, 1, drive);
}

TEST(RunApart, TellsWhatTheDriverFound) {
  const Report nothing = run_with([](const Done& done) { done({7, ""}); });
  EXPECT_FALSE(nothing.detected);
  EXPECT_EQ(nothing.executions, 7);
  const Report found = run_with([](const Done& done) { done({1, "wrong\nand why"}); });
  EXPECT_TRUE(found.detected);
  EXPECT_STREQ(found.found, "wrong");
}

TEST(RunApart, MarksATextThatItHasNoRoomFor) {
  std::string umlauts;
  for (int i = 0; i < 1000; ++i) umlauts += "ü";
  const std::string odd = run_with([&](const Done& done) { done({1, umlauts}); }).found;
  const std::string even = run_with([&](const Done& done) { done({1, " " + umlauts}); }).found;
  EXPECT_THAT(odd, EndsWith("ü…"));
  EXPECT_THAT(even, EndsWith("ü…"));
  EXPECT_LT(odd.size(), sizeof Report::found);
  EXPECT_GT(odd.size() + 8, sizeof Report::found);
}

TEST(RunApart, ACrashOrAnExitIsNoticed) {
  const Report crash = run_with([](const Done&) { std::abort(); });
  EXPECT_TRUE(crash.detected && crash.died);
  EXPECT_STREQ(crash.found, "the process ends by signal 6");
  const Report exit = run_with([](const Done&) { _exit(5); });
  EXPECT_TRUE(exit.detected && exit.died);
  EXPECT_STREQ(exit.found, "the process ends by itself: 5");
}

TEST(RunApart, AnExceptionEndsTheCopyAndNotItsCaller) {
  const Report thrown = run_with([](const Done&) { throw std::runtime_error("x"); });
  EXPECT_STREQ(thrown.found, "the process ends by signal 6");
}

TEST(RunApart, AStepThatHangsIsNoticed) {
  const Report hang = run_with([](const Done&) {
    Heartbeat().beat();
    while (cpu_seconds_used() >= 0) continue;
  });
  EXPECT_TRUE(hang.detected && hang.died);
  EXPECT_STREQ(hang.found, "it hangs: one step takes 5 s");
}

TEST(RunApart, ARunWithoutHeartbeatEndsToo) {
  const Report hang = run_apart(planted::kNone, 0, [](const Done&) {
    while (cpu_seconds_used() >= 0) continue;
  });
  EXPECT_TRUE(hang.detected && hang.died);
  EXPECT_STREQ(hang.found, "it hangs: it takes 5 s");
}

/// What run_apart throws.
std::string trouble_of(const std::function<void(const Done&)>& drive) {
  try {
    return std::string("no trouble: ") + run_with(drive).found;
  } catch (const std::exception& error) {
    return error.what();
  }
}

TEST(RunApart, ADeathFromOutsideSaysNothingOfTheSources) {
  for (const int signal : {SIGKILL, SIGTERM, SIGINT, SIGHUP, SIGQUIT}) {
    EXPECT_THAT(trouble_of([&](const Done&) { raise(signal); }),
                StartsWith("the run was ended from outside, by signal " + std::to_string(signal)));
  }
}

TEST(RunApart, AnEndWithoutAReportSaysNothingEither) {
  EXPECT_EQ(trouble_of([](const Done&) { _exit(0); }), "the run ended without a report");
  EXPECT_EQ(trouble_of([](const Done&) {}), "the run ended without a report");
}

TEST(RunApart, ACopyHoldsNoFileOfItsCaller) {
  const int file = open("/dev/null", O_RDONLY);
  const Report report = run_with([&](const Done& done) {
    done({1, fcntl(file, F_GETFD) < 0 ? "" : "it is open"});
  });
  close(file);
  EXPECT_STREQ(report.found, "");
}

/// In a process of its own: where there are no more processes for this user.
[[noreturn]] void run_where_no_process_is_to_be_had() {
  if (geteuid() == 0 && setuid(61234) != 0) _exit(77);  // root's are not limited
  const rlimit none{0, 0};
  setrlimit(RLIMIT_NPROC, &none);
  std::fputs(trouble_of([](const Done& done) { done({}); }).c_str(), stderr);
  _exit(3);
}

TEST(RunApartDeathTest, ReportsNothingWithoutAProcess) {
  EXPECT_EXIT(run_where_no_process_is_to_be_had(), testing::ExitedWithCode(3),
              "^cannot start a process: ");
}

}  // namespace
}  // namespace ccdfuzz
