#include <gtest/gtest.h>

#include <algorithm>
#include <regex>

#include "process.hpp"

namespace ccdfuzz {
namespace {

/// In a folder with the corpus and two small data sets, where the program is called "ccdfuzz".
std::string in_a_folder(const ScratchFolder& folder, const std::string& line) {
  const Finished finished = shell(fmt::format(
      "cd '{}' && ln -s \"$ccdfuzz\" ccdfuzz && ln -s {}/corpus corpus && PATH=$PWD:$PATH && "
      "ccdfuzz generate --contact VV --kind RP --count 20 -o vv.jsonl 2> made && "
      "ccdfuzz generate --contact EE --kind RN --count 3 -o ee.jsonl 2> made && {}",
      folder.path(), CCDFUZZ_SOURCE_DIR, line));
  EXPECT_LE(finished.code, 1) << line << finished.err;
  return finished.out;
}

std::ptrdiff_t columns_of(const std::string& line) {
  return std::ranges::count_if(line, [](char c) { return (c & 0xC0) != 0x80; });
}

/// Paths and commands to paste are as long as they are.
void expect_narrow(const std::string& text, const std::string& of) {
  static const std::regex kToPaste("ccdfuzz (query|check|replay) ");
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (std::regex_search(line, kToPaste)) continue;
    EXPECT_LE(columns_of(line), 80) << of << "\n" << line;
  }
}

class Output : public testing::TestWithParam<const char*> {};

TEST_P(Output, FitsATerminalAndEndsWithItsSummary) {
  const ScratchFolder folder;
  const std::string out = in_a_folder(folder, GetParam());
  expect_narrow(out, GetParam());
  EXPECT_LE(std::ranges::count(out, '\n'), 40) << out;
  const size_t last = out.rfind('\n', out.size() - 2);
  ASSERT_NE(last, std::string::npos) << out;
  EXPECT_TRUE(std::regex_search(out.substr(last), std::regex("[0-9]"))) << out;
}

INSTANTIATE_TEST_SUITE_P(
    OfCommands, Output,
    testing::Values("ccdfuzz hunt --cases 1 --max-pops 50",
                    "ccdfuzz hunt --linear --cases 1 --max-pops 50",
                    "ccdfuzz query corpus/cases/tdibm-late-past-the-contact.json",
                    "ccdfuzz replay corpus",
                    "ccdfuzz replay vv.jsonl --expect correct --methods tdibm",
                    "ccdfuzz evaluate vv.jsonl ee.jsonl", "ccdfuzz check --count 3",
                    "ccdfuzz check tdibm.separation tdibm.trace --count 50",
                    "ccdfuzz trace corpus/cases/tdibm-late-past-the-contact.json",
                    "ccdfuzz bench --count 1 --max-pops 50", "ccdfuzz methods"),
    [](const auto& command) { return fmt::format("{}", command.index); });

TEST(OutputByClass, FitsATerminalToo) {
  const ScratchFolder folder;
  expect_narrow(in_a_folder(folder,
                            "ccdfuzz hunt --cases 1 --max-pops 50 --by-class && ccdfuzz evaluate "
                            "vv.jsonl ee.jsonl --by-class"),
                "--by-class");
}

TEST(Help, FitsATerminalAndHasAnExample) {
  EXPECT_GE(commands().size(), 18U);
  expect_narrow(ccdfuzz({"--help"}).out, "--help");
  expect_narrow(ccdfuzz({"properties"}).out, "properties");
  for (const std::string& command : commands()) {
    const Finished shown = succeeded(ccdfuzz({command, "--help"}));
    const std::string& help = shown.out;
    expect_narrow(help, command);
    EXPECT_THAT(help, testing::HasSubstr("\nExample, "));
    EXPECT_THAT(help, testing::HasSubstr("\n  ccdfuzz " + command));
    EXPECT_THAT(help, testing::Not(testing::HasSubstr("TEXT"))) << "says what a value is: ";
    EXPECT_EQ(ccdfuzz({"help", command}).out, help);
  }
  EXPECT_EQ(ccdfuzz({"help"}).out, ccdfuzz({"--help"}).out);
  EXPECT_EQ(ccdfuzz({"-V"}).out, ccdfuzz({"--version"}).out);
}

}  // namespace
}  // namespace ccdfuzz
