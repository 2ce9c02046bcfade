#include "io/table.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "base/verify.hpp"

namespace ccdfuzz {
namespace {

Table sample() {
  Table table({{"name", Align::kLeft}, {"n"}, {"note", Align::kLeft}});
  table.add_row({{"a"}, {"1", true}, {"µs"}});
  table.start_group();
  table.add_row({{"long name"}, {"1000"}, {"x"}});
  return table;
}

TEST(Table, TextAlignsByCodePointsAndLeavesNoTrailingBlanks) {
  EXPECT_EQ(sample().to_text(false),
            "name          n  note\n"
            "a             1  µs\n"
            "\n"
            "long name  1000  x\n");
}

TEST(Table, WiderThanATerminalIsShownInPartsThatBeginWithTheTextsToTheLeft) {
  const std::string wide(40, '=');
  Table table({{"name", Align::kLeft}, {wide}, {"n"}, {wide + "="}, {"m"}});
  table.add_row({{"a"}, {"1"}, {"2"}, {"3"}, {"4"}});
  const auto blanks = [](size_t count) { return std::string(count, ' '); };
  EXPECT_EQ(table.to_text(false), "name  " + wide + "  n\na     " + blanks(39) + "1  2\n\n" +
                                      "name  " + wide + "=  m\na     " + blanks(40) + "3  4\n");
}

TEST(Table, AGroupHasItsTitleAndALongTextItsEnd) {
  Table table({{"name", Align::kLeft, 0, 4}, {"n"}});
  table.start_group("first");
  table.add_row({{"aµbµcd"}, {"1"}});
  table.add_row({{"abcd"}, {"2"}});
  EXPECT_EQ(table.to_text(false), "name  n\n\nfirst\n…µcd  1\nabcd  2\n");
}

TEST(Table, ShowsControlCharactersAndDoesNotSendThem) {
  Table table({{"name", Align::kLeft}, {"n"}});
  table.add_row({{"a\x1b[31m\nb"}, {"1"}});
  EXPECT_EQ(table.to_text(false),
            "name            n\n"
            "a\\u001b[31m\\nb  1\n");
  EXPECT_EQ(table.to_markdown(),
            "| name | n |\n"
            "|:--|--:|\n"
            "| a\\u001b[31m\\nb | 1 |\n");
}

TEST(Table, ColourOnlyAddsEscapes) {
  std::string coloured = sample().to_text(true);
  EXPECT_NE(coloured, sample().to_text(false));
  for (size_t at; (at = coloured.find('\x1b')) != std::string::npos;) {
    coloured.erase(at, coloured.find('m', at) - at + 1);
  }
  EXPECT_EQ(coloured, sample().to_text(false));
}

TEST(Table, MarkdownKeepsBarsInsideTheirCell) {
  Table table({{"a", Align::kLeft}, {"b"}});
  table.add_row({{"x|y"}, {"2"}});
  EXPECT_EQ(table.to_markdown(), "| a | b |\n|:--|--:|\n| x\\|y | 2 |\n");
}

TEST(Table, RefusesARowOfTheWrongLength) {
  Table table({{"a"}, {"b"}});
  EXPECT_THROW(table.add_row({{"1"}}), InternalError);
}

TEST(Duration, HasThreeDigitsInTheUnitThatFits) {
  EXPECT_EQ(duration_text(0), "0 s");
  EXPECT_EQ(duration_text(1.5e-9), "1.50 ns");
  EXPECT_EQ(duration_text(1e-12), "0.00 ns");
  EXPECT_EQ(duration_text(0.0123456), "12.3 ms");
  EXPECT_EQ(duration_text(0.5), "500 ms");
  EXPECT_EQ(duration_text(151.2), "151 s");
  EXPECT_EQ(duration_text(std::nan("")), "0 s");
}

TEST(Duration, RoundingUpNeverLeavesFourDigitsOfTheSmallerUnit) {
  EXPECT_EQ(duration_text(0.9996e-3), "1.00 ms");
  EXPECT_EQ(duration_text(0.09996), "100 ms");
  EXPECT_EQ(duration_text(9.996e-6), "10.0 µs");
}

TEST(Count, AShareAboveZeroNeverReadsAsZero) {
  EXPECT_EQ(count_text(0, 1000), "0");
  EXPECT_EQ(count_text(1, 6003), "1 (0.02 %)");
  EXPECT_EQ(count_text(223, 1000), "223 (22.3 %)");
  EXPECT_EQ(count_text(3, 0), "3");
}

TEST(Table, SizesHaveThreeDigits) {
  EXPECT_EQ(size_text(0), "0 B");
  EXPECT_EQ(size_text(999), "999 B");
  EXPECT_EQ(size_text(1000), "0.98 KiB");
  EXPECT_EQ(size_text(1536), "1.50 KiB");
  EXPECT_EQ(size_text(102400), "100 KiB");
  EXPECT_EQ(size_text(256.0 * (1 << 20)), "256 MiB");
}

}  // namespace
}  // namespace ccdfuzz
