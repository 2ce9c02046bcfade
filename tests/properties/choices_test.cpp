#include "generators/draw/draw.hpp"

#include <cmath>

#include "rapidcheck.hpp"

namespace ccdfuzz {
namespace {

/// Some of everything that can be drawn, as comparable numbers.
std::vector<std::int64_t> draw_everything(Draw& choices) {
  std::vector<std::int64_t> drawn;
  drawn.push_back(choices.integer(-3, 1000));
  drawn.push_back(choices.coin());
  drawn.push_back(std::bit_cast<std::int64_t>(choices.finite_double()));
  const Dyadic d = choices.dyadic(61, 0);
  drawn.push_back(d.sign() == 0 ? 0 : d.mantissa().get_si());
  drawn.push_back(static_cast<std::int64_t>(choices.choose(0)));
  drawn.push_back(static_cast<std::int64_t>(choices.choose(256)));
  for (const char c : choices.text(5)) drawn.push_back(c);
  return drawn;
}

RC_GTEST_PROP(Choices, TheBytesOfASequenceDrawTheSameAgain, (std::vector<std::uint64_t> numbers)) {
  Draw stored = Draw::from_numbers(numbers);
  const auto drawn = draw_everything(stored);
  const std::vector<std::uint8_t> bytes = stored.bytes();
  Draw again = Draw::from_bytes(bytes);
  RC_ASSERT(draw_everything(again) == drawn);
  RC_ASSERT(again.bytes() == bytes);
  RC_ASSERT(parse_hex_bytes(to_hex_bytes(bytes)) == bytes);
}

RC_GTEST_PROP(Choices, RandomOnesComeAgainFromTheirBytesToo, (std::uint64_t seed)) {
  Draw random = Draw::mostly_small(Random(seed));
  const auto drawn = draw_everything(random);
  Draw again = Draw::from_bytes(random.bytes());
  RC_ASSERT(draw_everything(again) == drawn);
}

TEST(Choices, AnExhaustedSourceDrawsTheSimplest) {
  for (const bool stored : {true, false}) {
    Draw none = Draw::from_numbers({});
    Draw empty = Draw::from_bytes({});
    Draw& choices = stored ? static_cast<Draw&>(none) : empty;
    EXPECT_EQ(choices.integer(-5, 5), 0);
    EXPECT_EQ(choices.integer(3, 9), 3);
    EXPECT_EQ(choices.integer(-9, -3), -3);
    EXPECT_EQ(choices.finite_double(), 0.0);
    EXPECT_EQ(choices.dyadic(10, -3), Dyadic());
    EXPECT_FALSE(choices.coin());
    EXPECT_EQ(choices.text(10), "");
  }
}

TEST(Choices, IntegerReachesEveryValueOnceInOrderOfSimplicity) {
  for (const auto& [lo, hi] : {std::pair{-2, 5}, {-5, 2}, {0, 4}, {-4, 0}, {3, 6}, {-6, -3}}) {
    std::vector<std::int64_t> drawn;
    for (std::uint64_t c = 0; c <= static_cast<std::uint64_t>(hi - lo); ++c) {
      drawn.push_back(Draw::from_numbers({c}).integer(lo, hi));
    }
    EXPECT_TRUE(
        std::is_sorted(drawn.begin(), drawn.end(),
                       [](std::int64_t a, std::int64_t b) { return std::abs(a) < std::abs(b); }))
        << lo << ".." << hi;
    std::sort(drawn.begin(), drawn.end());
    for (int x = lo; x <= hi; ++x) EXPECT_EQ(drawn[static_cast<std::size_t>(x - lo)], x);
  }
}

RC_GTEST_PROP(Choices, FiniteDoublesAreFiniteAndReachEveryFiniteBitPattern, (std::uint64_t bits)) {
  const double drawn = Draw::from_numbers({bits}).finite_double();
  RC_ASSERT(std::isfinite(drawn));
  const double wanted = std::bit_cast<double>(bits);
  if (std::isfinite(wanted)) RC_ASSERT(std::bit_cast<std::uint64_t>(drawn) == bits);
}

TEST(Choices, OneByteChangesOneChoiceOnly) {
  const std::vector<std::uint8_t> a = {1, 2, 3}, b = {1, 200, 3};
  Draw x = Draw::from_bytes(a), y = Draw::from_bytes(b);
  EXPECT_EQ(x.choose(255), y.choose(255));
  EXPECT_NE(x.choose(255), y.choose(255));
  EXPECT_EQ(x.choose(255), y.choose(255));
}

TEST(Choices, HexTextOfOtherFormsIsRefused) {
  for (const char* bad : {"0", "0g", "0x", "00 ", "AB"}) EXPECT_FALSE(parse_hex_bytes(bad)) << bad;
  EXPECT_EQ(parse_hex_bytes(""), std::vector<std::uint8_t>());
  EXPECT_EQ(to_hex_word({}), "''");
  EXPECT_EQ(to_hex_word(std::vector<std::uint8_t>{0, 255}), "00ff");
}

}  // namespace
}  // namespace ccdfuzz
