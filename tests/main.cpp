// The main of every test executable: RapidCheck draws the same cases in every run, unless told
// otherwise, and a failure prints the one command that shows it again.
//   CCDFUZZ_SEED     seed of RapidCheck and test_seed, default 1; "random" draws and prints one
//   CCDFUZZ_EFFORT   whole factor on the number of cases, 1 to 1000000, default 1
//   RC_PARAMS        RapidCheck's own, instead of both
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>
#include <cstdlib>
#include <iostream>
#include <random>
#include <string>

#include "numeric/effort.hpp"
#include "served_by_test.hpp"
#include "share.hpp"

void (*ccdfuzz::served_by_test)(int, char**) = nullptr;

namespace {

constexpr unsigned long kCasesPerProperty = ccdfuzz::kOneIn == 1 ? 100 : 25;

std::string from_environment(const char* name, const std::string& otherwise) {
  const char* value = std::getenv(name);
  return value == nullptr || *value == '\0' ? otherwise : value;
}

unsigned long number(const std::string& name, const std::string& text) {
  if (text.empty() || text.size() > 18 ||
      text.find_first_not_of("0123456789") != std::string::npos) {
    std::cerr << name << ": \"" << text << "\" is not a whole number\n";
    std::exit(2);
  }
  return std::stoul(text);
}

unsigned long effort_or_exit() {
  const auto effort = ccdfuzz::effort();
  if (effort) return *effort;
  std::cerr << effort.error().message() << "\n";
  std::exit(2);
}

/// What a run depends on, as the assignments before its command.
std::string fix_random_cases() {
  const unsigned long effort = effort_or_exit();
  const std::string own = from_environment("RC_PARAMS", "");
  if (!own.empty()) return "RC_PARAMS='" + own + "' ";
  const std::string asked = from_environment("CCDFUZZ_SEED", "1");
  const unsigned long seed =
      asked == "random" ? std::random_device{}() : number("CCDFUZZ_SEED", asked);
  setenv("CCDFUZZ_SEED", std::to_string(seed).c_str(), 1);  // for test_seed
  const std::string params =
      "seed=" + std::to_string(seed) + " max_success=" + std::to_string(kCasesPerProperty * effort);
  setenv("RC_PARAMS", params.c_str(), 1);  // before RapidCheck reads it, at the first property
  return "CCDFUZZ_SEED=" + std::to_string(seed) + " CCDFUZZ_EFFORT=" + std::to_string(effort) + " ";
}

class PrintsHowToReproduce : public testing::EmptyTestEventListener {
 public:
  explicit PrintsHowToReproduce(std::string command) : command_(std::move(command)) {}

 private:
  void OnTestEnd(const testing::TestInfo& info) override {
    if (info.result()->Passed() || info.result()->Skipped()) return;
    std::cout << "reproduce: " << command_ << " --gtest_filter='" << info.test_suite_name() << '.'
              << info.name() << "'" << std::endl;
  }

  std::string command_;
};

}  // namespace

int main(int argc, char** argv) {
  std::signal(SIGINT, SIG_DFL);  // ignored, it would be in what tests start, too
  if (ccdfuzz::served_by_test != nullptr) ccdfuzz::served_by_test(argc, argv);
  const std::string assignments = fix_random_cases();
  testing::InitGoogleMock(&argc, argv);
  testing::UnitTest::GetInstance()->listeners().Append(
      new PrintsHowToReproduce(assignments + argv[0]));
  return RUN_ALL_TESTS();
}
