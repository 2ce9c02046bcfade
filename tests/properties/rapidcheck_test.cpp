// RapidCheck as the driver of every registered property: it makes and shrinks the choices.
#include <fmt/format.h>

#include <iostream>

#include "generators/draw/choice_bytes.hpp"
#include "generators/rc/drawn.hpp"
#include "properties/suites.hpp"
#include "rapidcheck.hpp"
#include "share.hpp"

namespace ccdfuzz {

/// How GoogleTest names the parameter of a test.
static void PrintTo(const Property& property, std::ostream* out) {
  *out << property.name;
}

namespace {

/// The one command that shows a failure again, whatever becomes of RapidCheck's seeds.
std::string replay_command(const Property& property, const Draw& choices) {
  return fmt::format("reproduce (--save keeps it): {} check {} --choices {}", CCDFUZZ_EXECUTABLE,
                     property.name, to_word(choices.numbers()));
}

class EveryProperty : public testing::TestWithParam<Property> {};

TEST_P(EveryProperty, HoldsOnRandomChoicesOrFailsAsExpected) {
  const Property& property = GetParam();
  if (property.expected == Expectation::kHolds) {
    const bool held = rc::check(std::string(property.claim), [&] {
      // RapidCheck gives up where more than nine of ten are discarded; some claims are of rarer
      // inputs than that.
      constexpr int kMostDraws = 64;
      Draw choices = Draw::from_numbers(*gen::choices());
      Check check = run(property, choices);
      for (int i = 1; i < kMostDraws && check.status == Check::Status::kDiscarded; ++i) {
        choices = Draw::from_numbers(*gen::choices());
        check = run(property, choices);
      }
      RC_PRE(check.status != Check::Status::kDiscarded);
      if (check.status == Check::Status::kFails) {
        RC_FAIL(check.text + "\n" + replay_command(property, choices));
      }
    });
    EXPECT_TRUE(held);
    return;
  }
  // A claim that is known to be false: a harness that cannot show it is blind.
  constexpr std::uint64_t kTries = 20'000;
  for (std::uint64_t i = 0; i < kTries; ++i) {
    Draw choices = Draw::mostly_small(Random::keyed({1, i}));
    const Check check = run(property, choices);
    if (check.status != Check::Status::kFails) continue;
    std::cout << "found as expected, case " << i << ": " << check.text << '\n'
              << replay_command(property, choices) << '\n';
    return;
  }
  FAIL() << "no counterexample to \"" << property.claim << "\" in " << kTries << " tries";
}

/// All; but where code is slow, not what is known to be false: corpus/claims has those
/// inputs.
std::vector<Property> driven_properties() {
  std::vector<Property> driven = properties();
  if (kOneIn > 1) {
    std::erase_if(driven, [](const Property& p) { return p.expected != Expectation::kHolds; });
  }
  return driven;
}

INSTANTIATE_TEST_SUITE_P(Registered, EveryProperty, testing::ValuesIn(driven_properties()),
                         [](const auto& test) {
                           std::string name(test.param.name);
                           for (char& c : name) {
                             if (c == '.' || c == '-') c = '_';
                           }
                           return name;
                         });

}  // namespace
}  // namespace ccdfuzz
