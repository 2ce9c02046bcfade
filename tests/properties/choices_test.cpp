#include "generators/draw/choice_bytes.hpp"
#include "generators/draw/draw.hpp"
#include "generators/draw/mutate_choices.hpp"

#include <algorithm>
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

RC_GTEST_PROP(Choices, TheBytesOfASequenceAreItAgain, (std::vector<std::uint64_t> numbers)) {
  RC_ASSERT(choices_of(bytes_of(numbers)) == numbers);
  if (!numbers.empty()) RC_ASSERT(*parse_choices(to_word(numbers)) == numbers);
}

RC_GTEST_PROP(Choices, AnyBytesAreChoicesWhoseBytesAreThemAgain,
              (std::vector<std::uint8_t> bytes)) {
  const ChoiceNumbers numbers = choices_of(bytes);
  RC_ASSERT(numbers.size() <= bytes.size());
  RC_ASSERT(choices_of(bytes_of(numbers)) == numbers);
}

RC_GTEST_PROP(Choices, RandomOnesDrawTheSameAgain, (std::uint64_t seed)) {
  Draw random = Draw::mostly_small(Random(seed));
  const auto drawn = draw_everything(random);
  Draw again = Draw::from_numbers(random.numbers());
  RC_ASSERT(draw_everything(again) == drawn);
  RC_ASSERT(again.numbers() == random.numbers());
}

TEST(Choices, AnExhaustedSourceDrawsTheSimplest) {
  Draw choices = Draw::from_numbers({});
  EXPECT_EQ(choices.integer(-5, 5), 0);
  EXPECT_EQ(choices.integer(3, 9), 3);
  EXPECT_EQ(choices.integer(-9, -3), -3);
  EXPECT_EQ(choices.finite_double(), 0.0);
  EXPECT_EQ(choices.dyadic(10, -3), Dyadic());
  EXPECT_FALSE(choices.coin());
  EXPECT_EQ(choices.text(10), "");
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

TEST(Choices, WordsOfOtherFormsAreRefused) {
  for (const char* bad : {",", "1,", "-1", "+1", " 1", "1.0", "18446744073709551616", "x"}) {
    EXPECT_FALSE(parse_choices(bad)) << bad;
  }
  EXPECT_EQ(*parse_choices(""), ChoiceNumbers());
  EXPECT_EQ(to_word({}), "''");
  EXPECT_EQ(to_word({0, 18446744073709551615U}), "0,18446744073709551615");
}

RC_GTEST_PROP(Choices, AMutantOfChoicesIsNearThem, (ChoiceNumbers numbers, std::uint64_t seed)) {
  Draw random{Random(seed)};
  const ChoiceNumbers mutant = mutated(numbers, random);
  const auto size = static_cast<std::int64_t>(numbers.size());
  RC_ASSERT(std::abs(static_cast<std::int64_t>(mutant.size()) - size) <= 4 * 8);
}

RC_GTEST_PROP(Choices, AChildBeginsAsItsMotherAndEndsAsItsFather,
              (ChoiceNumbers mother, ChoiceNumbers father, std::uint64_t seed)) {
  Draw random{Random(seed)};
  const ChoiceNumbers child = crossed(mother, father, random);
  const auto [from_mother, in_mother] = std::ranges::mismatch(child, mother);
  const auto [rest, in_father] =
      std::mismatch(child.rbegin(), child.rend(), father.rbegin(), father.rend());
  RC_ASSERT((from_mother - child.begin()) + (rest - child.rbegin()) >=
            static_cast<std::ptrdiff_t>(child.size()));
}

}  // namespace
}  // namespace ccdfuzz
