#include "base/number_text.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cfenv>

namespace ccdfuzz {
namespace {

TEST(NumberText, ReadsWhatPeopleWrite) {
  EXPECT_EQ(parse_number("--x", "1"), 1.0);
  EXPECT_EQ(parse_number("--x", ".5"), 0.5);
  EXPECT_EQ(parse_number("--x", "1e-6"), 1e-6);
  EXPECT_EQ(parse_number("--x", "2^-20"), 0x1p-20);
  EXPECT_EQ(parse_number("--x", "2^10"), 1024.0);
  EXPECT_EQ(parse_number("--x", "1+2^-30"), 1 + 0x1p-30);
  EXPECT_EQ(parse_number("--x", "1-2^-20"), 1 - 0x1p-20);
  EXPECT_EQ(parse_number("--x", "0x1.8p-3"), 0x1.8p-3);
  EXPECT_EQ(parse_number("--x", "-3"), -3.0);
  EXPECT_EQ(parse_list("--x", "1,1+2^-30,1.5", parse_number),
            (std::vector<double>{1, 1 + 0x1p-30, 1.5}));
}

TEST(NumberText, ReadsTheSameInEveryRoundingMode) {
  for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
    std::fesetround(mode);
    const Result<double> number = parse_number("--x", "1e-12");
    std::fesetround(FE_TONEAREST);
    EXPECT_EQ(number, 0x1.19799812dea11p-40);
  }
}

TEST(NumberText, RefusesTheRestNamingOptionAndText) {
  for (const char* text :
       {"",      " ",       "x",         "1x",      "1 ",      " 1",     "+1",  "1+",
        "1++1",  "nan",     "inf",       "-inf",    "1e999",   "2^",     "2^x", "2^99999",
        "2^1.5", "3^2",     "0x",        "0x-1",    "0xinf",   "0xnan",  "1,2", "--1",
        ".",     "2^-1075", "1+2^-2000", "1+2^-53", "2^-60+1", "1-1e-30"}) {
    const auto number = parse_number("--option", text);
    ASSERT_FALSE(number) << text << " was read as " << *number;
    EXPECT_EQ(number.error().where, "--option");
    EXPECT_NE(number.error().what.find(fmt::format("\"{}\"", text)), std::string::npos);
  }
  for (const char* text : {"", ",", "1,", ",1", "1,,2", "1;2", "1,2,1.0"}) {
    EXPECT_FALSE(parse_list("--option", text, parse_number)) << text;
  }
}

TEST(NumberText, ReadsTheSmallestTermsThatCount) {
  EXPECT_EQ(parse_number("--x", "2^-1074"), 0x1p-1074);
  EXPECT_EQ(parse_number("--x", "1+2^-52"), 1 + 0x1p-52);
  EXPECT_EQ(parse_number("--x", "0+1"), 1.0);
  EXPECT_EQ(parse_number("--x", "1+0"), 1.0);
}

TEST(NumberText, PowersOfTwoGiveTheirExponent) {
  EXPECT_EQ(parse_power_of_two("--x", "2^-20"), -20);
  EXPECT_EQ(parse_power_of_two("--x", "0.25"), -2);
  EXPECT_EQ(parse_power_of_two("--x", "1"), 0);
  EXPECT_EQ(parse_power_of_two("--x", "0x1p-40"), -40);
  for (const char* text : {"0", "3", "1e-6", "-2", "2^-20+2^-30", "2^-2000"}) {
    EXPECT_FALSE(parse_power_of_two("--x", text)) << text;
  }
}

TEST(NumberText, WholeNumbersAreDecimalAndFit64Bits) {
  EXPECT_EQ(parse_whole("--x", "0"), 0U);
  EXPECT_EQ(parse_whole("--x", "10"), 10U);
  EXPECT_EQ(parse_whole("--x", "18446744073709551615"), 18446744073709551615U);
  for (const char* text : {"", " ", "-1", "+1", "010", "00", "1.0", "1e3", "0x7", " 5", "5 ",
                           "18446744073709551616", "five"}) {
    EXPECT_FALSE(parse_whole("--x", text)) << text;
  }
  EXPECT_LT(parse_whole("--x", std::string(300, '7')).error().what.size(), 120U);
}

}  // namespace
}  // namespace ccdfuzz
