#include "base/text.hpp"

#include <gtest/gtest.h>

namespace ccdfuzz {
namespace {

TEST(ShownLine, HasNothingThatATerminalObeys) {
  EXPECT_EQ(shown_line("a\x1b[31m\n\x7f\xc2\x9b"), "a\\u001b[31m\\n\\u007f\\u009b");
  EXPECT_EQ(shown_lines("a\nb\r"), "a\nb\\u000d");
  EXPECT_EQ(shell_word("it's\\"), "'it'\\''s\\'");
  EXPECT_EQ(shell_word("it's\t\\\n\xff"), R"($'it\'s\u0009\\\n\xff')");
}

TEST(ShownLine, KeepsEveryCharacterOfUtf8) {
  const std::string ends =
      "~\xc2\xa0\xdf\xbf\xe0\xa0\x80\xed\x9f\xbf\xee\x80\x80\xef\xbf\xbf"
      "\xf0\x90\x80\x80\xf4\x8f\xbf\xbf";
  EXPECT_EQ(shown_line(ends), ends);
}

TEST(ShownLine, ShowsEachByteThatIsOfNoCharacter) {
  EXPECT_EQ(shown_line("a\xff\x80z"), "a\\xff\\x80z");
  EXPECT_EQ(shown_line("\x9b\x31m"), "\\x9b1m") << "an escape of a terminal of 8 bits";
  EXPECT_EQ(shown_line("\xc3"), "\\xc3") << "cut off";
  EXPECT_EQ(shown_line("\xe2\x82z"), "\\xe2\\x82z");
  EXPECT_EQ(shown_line("\xc1\xbf"), "\\xc1\\xbf") << "longer than needed";
  EXPECT_EQ(shown_line("\xe0\x9f\xbf"), "\\xe0\\x9f\\xbf");
  EXPECT_EQ(shown_line("\xf0\x8f\xbf\xbf"), "\\xf0\\x8f\\xbf\\xbf");
  EXPECT_EQ(shown_line("\xed\xa0\x80"), "\\xed\\xa0\\x80") << "a surrogate";
  EXPECT_EQ(shown_line("\xf4\x90\x80\x80"), "\\xf4\\x90\\x80\\x80") << "past U+10FFFF";
  EXPECT_EQ(shown_line("\xf8\x88\x80\x80\x80"), "\\xf8\\x88\\x80\\x80\\x80");
}

}  // namespace
}  // namespace ccdfuzz
