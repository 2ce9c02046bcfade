#include "generators/draw/draw.hpp"

#include <gtest/gtest.h>

#include <set>

#include "generators/generate.hpp"

namespace ccdfuzz {
namespace {

// The values are those of the published SplitMix64 started at 0.
TEST(Random, IsSplitMix64) {
  Draw random{Random(0)};
  EXPECT_EQ(random.choose(~std::uint64_t{0}), 0xe220a8397b1dcdafu);
  EXPECT_EQ(random.choose(~std::uint64_t{0}), 0x6e789e6aa1b965f4u);
  EXPECT_EQ(random.choose(~std::uint64_t{0}), 0x06c45d188009454fu);
}

TEST(Random, BelowHitsEveryValueAboutEquallyOftenAndNoOther) {
  for (const std::uint64_t bound : {1u, 2u, 3u, 6u, 17u}) {
    Draw random{Random(bound)};
    std::vector<int> count(bound);
    constexpr int kDraws = 20000;
    for (int i = 0; i < kDraws; ++i) ++count.at(random.below(bound));
    // Six standard deviations of a binomial count, whose variance is below its mean.
    const double mean = static_cast<double>(kDraws) / static_cast<double>(bound);
    for (const int c : count) EXPECT_NEAR(c, mean, 6 * std::sqrt(mean)) << "bound " << bound;
  }
}

TEST(Draw, LatticeStaysInItsRangeAndOnItsGrid) {
  Draw random{Random(2)};
  for (int i = 0; i < 1000; ++i) {
    const Dyadic x = random.lattice(7, -3);
    EXPECT_LE(abs(x), Dyadic(16)) << x;
    EXPECT_GE(x.sign() == 0 ? 0 : x.exponent(), -3) << x;
  }
}

TEST(Random, KeysThatDifferInOnePlaceOrInOrderGiveDifferentStreams) {
  std::set<std::uint64_t> first;
  for (std::uint64_t a = 0; a < 32; ++a) {
    for (std::uint64_t b = 0; b < 32; ++b) first.insert(Random::keyed({a, b}).next());
    first.insert(Random::keyed({a}).next());
  }
  EXPECT_EQ(first.size(), 32u * 33u);
}

bool never(std::uint64_t) {
  return false;
}

TEST(Draw, UntilEndsOnStoredNumbersThatAreNeverGood) {
  int made = 0;
  const auto drawn_until_never = [&](Draw draw) {
    made = 0;
    draw.until([&] { return ++made, draw.choose(255); }, never);
  };
  EXPECT_THROW(drawn_until_never(Draw::from_numbers({})), Discarded);
  EXPECT_EQ(made, 1) << "at its end it gives the same for ever";
  EXPECT_THROW(drawn_until_never(Draw::from_numbers({1, 2, 3})), Discarded);
  EXPECT_EQ(made, 3);
  EXPECT_THROW(drawn_until_never(Draw::from_numbers(ChoiceNumbers(1000, 7))), Discarded);
  EXPECT_EQ(made, Draw::kMostTries);
}

TEST(Draw, UntilKeepsNoneOfWhatWasRefused) {
  Draw draw{Random(5)};
  draw.record();
  const auto is_large = [](std::uint64_t x) { return x >= 250; };
  const std::uint64_t large = draw.until([&] { return draw.choose(255); }, is_large);
  EXPECT_EQ(draw.numbers(), ChoiceNumbers{large});
}

/// Every construction and family: what was recorded of the stream makes the same case again.
TEST(Draw, RecordedChoicesOfAGeneratedCaseMakeItAgain) {
  for (const Family family : kFamilies) {
    for (const ContactClass contact : kContactClasses) {
      for (const Construction construction : kConstructions) {
        GeneratorOptions options{
            .contact = contact, .construction = construction, .family = family};
        if (!validate(options)) continue;
        SCOPED_TRACE(std::string(name_of(family)) + " " + std::string(name_of(contact)));
        Draw stream(Random::keyed({7, static_cast<std::uint64_t>(contact)})), recorded = stream;
        recorded.record();
        const Case made = generate(options, recorded).value;
        EXPECT_EQ(made, generate(options, stream).value) << "recording changes nothing";
        Draw stored = Draw::from_numbers(recorded.numbers());
        EXPECT_EQ(made, generate(options, stored).value);
        EXPECT_EQ(stored.numbers(), recorded.numbers());
        EXPECT_TRUE(stream.numbers().empty()) << "a stream keeps nothing unless it is asked to";
      }
    }
  }
}

/// No choices at all, too few of them, only large ones: a case, or Discarded, and always an end.
TEST(Draw, EveryConstructionEndsOnExhaustedChoices) {
  for (const Family family : kFamilies) {
    for (const CaseKind kind : kCaseKinds) {
      GeneratorOptions options{.contact = ContactClass::kVV,
                               .kind = kind,
                               .construction = Construction::kOneSided,
                               .family = family,
                               .proof_pops = 100};
      if (!validate(options)) continue;
      for (const ChoiceNumbers& numbers :
           {ChoiceNumbers{}, ChoiceNumbers(30, 1), ChoiceNumbers(500, ~std::uint64_t{0})}) {
        Draw draw = Draw::from_numbers(numbers);
        try {
          EXPECT_TRUE(generate(options, draw).value.query.t_max >= 0);
        } catch (const Discarded&) {
        }
      }
    }
  }
}

}  // namespace
}  // namespace ccdfuzz
