#include "cli/input_watch.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>
#include <mutex>

namespace ccdfuzz {
namespace {

using std::chrono::milliseconds;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// What a watch told, from its thread.
class Told {
 public:
  InputWatch::Tell tell() {
    return [this](const std::string& text) {
      const std::lock_guard lock(mutex_);
      texts_.push_back(text);
    };
  }
  std::vector<std::string> texts() const {
    const std::lock_guard lock(mutex_);
    return texts_;
  }

 private:
  mutable std::mutex mutex_;
  std::vector<std::string> texts_;
};

constexpr milliseconds kLong{1'000'000}, kShort{100};

/// What a watch of this patience tells of an input that lasts until it was told of, and ten times
/// as long as the short patience beyond that.
std::vector<std::string> told_of_one(bool interrupted, InputWatch::Patience patience) {
  Told told;
  const std::atomic<bool> stop = interrupted;
  InputWatch watch({"a.b", "ccdfuzz check a.b --first ", " --count 1"}, 2, stop, told.tell(),
                   patience);
  const InputWatch::At at(watch, 17);
  while (told.texts().empty()) std::this_thread::sleep_for(milliseconds(10));
  std::this_thread::sleep_for(10 * kShort);
  return told.texts();
}

TEST(InputWatch, TellsOnceOfAnInputThatTakesLong) {
  EXPECT_THAT(told_of_one(false, {kShort, kShort}),
              ElementsAre("ccdfuzz: for 0.1 s now at an input of a.b, or its shrinking\n"
                          "reproduce: ccdfuzz check a.b --first 17 --count 1\n"));
}

TEST(InputWatch, TellsOnceOfAnInputThatIsWaitedForAfterAnInterruption) {
  EXPECT_THAT(told_of_one(true, {kLong, kShort}), ElementsAre(HasSubstr("--first 17 --count 1")));
}

TEST(InputWatch, SaysNothingOfInputsThatEndInTime) {
  constexpr milliseconds kPatience{300}, kLasts{60};
  const std::atomic<bool> stop = false;
  // Together the inputs last longer than the patience. Where the machine made one of them last so
  // long, which shows nothing, they are begun anew.
  for (bool is_starved = true; is_starved;) {
    is_starved = false;
    Told told;
    {
      InputWatch watch({"a.b", "", ""}, 1, stop, told.tell(), {kPatience, kPatience});
      for (std::uint64_t i = 0; i < 10; ++i) {
        const auto start = std::chrono::steady_clock::now();
        {
          const InputWatch::At at(watch, i);
          std::this_thread::sleep_for(kLasts);
        }
        is_starved = is_starved || std::chrono::steady_clock::now() - start >= kPatience;
      }
    }
    if (!is_starved) {
      EXPECT_THAT(told.texts(), IsEmpty());
    }
  }
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
