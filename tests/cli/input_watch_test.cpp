#include "cli/input_watch.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>

namespace ccdfuzz {
namespace {

using std::chrono::milliseconds;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// What a watch of this patience tells while an input lasts.
std::vector<std::string> told(bool interrupted, InputWatch::Patience patience, milliseconds lasts) {
  std::vector<std::string> texts;
  const std::atomic<bool> stop = interrupted;
  {
    InputWatch watch(
        {"a.b", "ccdfuzz check a.b --first ", " --count 1"}, 2, stop,
        [&](const std::string& text) { texts.push_back(text); }, patience);
    const InputWatch::At at(watch, 17);
    std::this_thread::sleep_for(lasts);
  }
  return texts;
}

constexpr milliseconds kLong{1'000'000}, kShort{100}, kLasts{600};

TEST(InputWatch, TellsOnceOfAnInputThatTakesLong) {
  EXPECT_THAT(told(false, {kShort, kShort}, kLasts),
              ElementsAre("ccdfuzz: for 0.1 s now at an input of a.b, or its shrinking\n"
                          "reproduce: ccdfuzz check a.b --first 17 --count 1\n"));
}

TEST(InputWatch, TellsOnceOfAnInputThatIsWaitedForAfterAnInterruption) {
  EXPECT_THAT(told(true, {kLong, kShort}, kLasts), ElementsAre(HasSubstr("--first 17 --count 1")));
}

TEST(InputWatch, SaysNothingOfInputsThatEndInTime) {
  EXPECT_THAT(told(true, {kLong, kLong}, kLasts), IsEmpty());
  std::vector<std::string> texts;
  const std::atomic<bool> stop = false;
  {
    InputWatch watch({"a.b", "", ""}, 1, stop,
                     [&](const std::string& text) { texts.push_back(text); },
                     {milliseconds(300), milliseconds(300)});
    for (std::uint64_t i = 0; i < 10; ++i) {
      const InputWatch::At at(watch, i);
      std::this_thread::sleep_for(milliseconds(60));
    }
  }
  EXPECT_THAT(texts, IsEmpty());
}

TEST(CrashSiteDeathTest, OnlyWhileAThreadIsThereIsACrashTold) {
  const std::string before = " before ", after = " after\n";
  EXPECT_EXIT(
      {
        const CrashSite site(before, 18446744073709551615U, after);
        std::abort();
      },
      testing::KilledBySignal(SIGABRT), "ccdfuzz: SIGABRT before 18446744073709551615 after\n");
  EXPECT_EXIT(
      {
        { const CrashSite site(before, 1, after); }
        std::abort();
      },
      testing::KilledBySignal(SIGABRT), "^$");
}

}  // namespace
}  // namespace ccdfuzz
