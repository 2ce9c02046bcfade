#include <gtest/gtest.h>

#include <regex>

#include "process.hpp"

namespace ccdfuzz {
namespace {

/// Everything that a line of shell shows on a terminal, as util-linux's script(1) records it.
std::string on_a_terminal(const std::string& line) {
  const ScratchFolder folder;
  write_text(folder / "line.sh", fmt::format("ccdfuzz='{}'\n{}\n", CCDFUZZ_EXECUTABLE, line));
  return shell(fmt::format("script -qec 'sh {}' /dev/null", folder / "line.sh")).out;
}

constexpr const char* kProgress = "\r\x1b[K[";
constexpr const char* kBold = "\x1b[1m";

std::string small_hunt(const ScratchFolder& folder, const std::string& redirection) {
  return fmt::format("$ccdfuzz hunt --cases 1 --methods tdibm --max-pops 10 --corpus {} {}",
                     folder / "finds", redirection);
}

TEST(Terminal, ShowsProgressAndColour) {
  const ScratchFolder folder;
  const std::string shown = on_a_terminal("unset NO_COLOR; TERM=xterm " + small_hunt(folder, ""));
  EXPECT_THAT(shown, testing::HasSubstr(kProgress));
  EXPECT_THAT(shown, testing::HasSubstr(kBold));
  // The progress line is wiped before the table.
  EXPECT_LT(shown.rfind(kProgress), shown.rfind("\r\x1b[K"));
  EXPECT_LT(shown.rfind("\r\x1b[K"), shown.find("undecided"));
}

TEST(Terminal, NoColorTakesTheColourAndLeavesTheProgress) {
  const ScratchFolder folder;
  const std::string shown = on_a_terminal("NO_COLOR=1 TERM=xterm " + small_hunt(folder, ""));
  EXPECT_THAT(shown, testing::HasSubstr(kProgress));
  EXPECT_THAT(shown, testing::Not(testing::HasSubstr(kBold)));
}

TEST(Terminal, OnlyTheStreamThatIsATerminalIsDressed) {
  const ScratchFolder folder;
  const std::string err_only =
      on_a_terminal("unset NO_COLOR; TERM=xterm " + small_hunt(folder, "> /dev/null"));
  EXPECT_THAT(err_only, testing::HasSubstr(kProgress));
  EXPECT_THAT(err_only, testing::Not(testing::HasSubstr(kBold)));
  const std::string out_only =
      on_a_terminal("unset NO_COLOR; TERM=xterm " + small_hunt(folder, "2> /dev/null"));
  EXPECT_THAT(out_only, testing::Not(testing::HasSubstr(kProgress)));
  EXPECT_THAT(out_only, testing::HasSubstr(kBold));
}

TEST(Terminal, TheProgressSaysTheRateAndTheTimeLeft) {
  const ScratchFolder folder;
  const std::string shown = on_a_terminal(fmt::format(
      "$ccdfuzz hunt --cases 100 --methods tdibm-c --corpus {} --json", folder / "finds"));
  EXPECT_THAT(shown, testing::HasSubstr(" queries/s  "));
  EXPECT_TRUE(std::regex_search(shown, std::regex("  [0-9]+:[0-9]{2} left  "))) << shown;
}

}  // namespace
}  // namespace ccdfuzz
