#include "generators/generate.hpp"
#include "certify/checker/check_case.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <thread>

#include "share.hpp"

namespace ccdfuzz {
namespace {

constexpr int kCasesPerClass = kOneIn == 1 ? 6 : 1;

std::string describe(const GeneratorOptions& options, std::uint64_t index) {
  return fmt::format("{} {} construction {} seed {} index {}", name_of(options.contact),
                     name_of(options.kind), static_cast<int>(options.construction), options.seed,
                     index);
}

/// Every regular kind of case, a few of each.
template <class Check>
void for_each_case(const Check& check) {
  for (const Construction construction : {Construction::kPaper, Construction::kOneSided}) {
    for (const ContactClass contact : kContactClasses) {
      for (const CaseKind kind : {CaseKind::kRP, CaseKind::kRN}) {
        GeneratorOptions options{.contact = contact, .kind = kind, .construction = construction};
        for (std::uint64_t index = 0; index < kCasesPerClass; ++index) {
          SCOPED_TRACE(describe(options, index));
          check(options, index, generate(options, index));
        }
      }
    }
  }
}

TEST(Generate, PositivesCarryAWitnessAtTheEndOfTheirHorizon) {
  for_each_case([](const GeneratorOptions& options, std::uint64_t, const Generated& made) {
    if (options.kind != CaseKind::kRP) return;
    const Case& c = made.value;
    ASSERT_TRUE(c.truth.witness);
    EXPECT_EQ(c.truth.witness->t, exact(c.query.t_max));
    // The plane of a one-sided case proves all of the time before.
    const bool is_paper = options.construction == Construction::kPaper;
    EXPECT_EQ(c.truth.clear_until,
              Rational(c.truth.witness->t - (is_paper ? power_of_two(-20) : Rational(0))));
  });
}

TEST(Generate, NegativesEndEpsTBeforeTheContactOfTheirPositive) {
  for_each_case([](const GeneratorOptions& options, std::uint64_t index, const Generated& made) {
    if (options.kind != CaseKind::kRN) return;
    GeneratorOptions positive = options;
    positive.kind = CaseKind::kRP;
    const Case& n = made.value;
    const Case p = generate(positive, index).value;
    EXPECT_EQ(n.query.patches, p.query.patches);
    EXPECT_EQ(exact(n.query.t_max), Rational(p.truth.witness->t - power_of_two(-20)));
    EXPECT_EQ(n.truth.collides, false);
    EXPECT_EQ(n.truth.proof, n.truth.clearance ? "P" : "rational-tdibm");
    EXPECT_EQ(n.truth.clear_until, exact(n.query.t_max));
    EXPECT_FALSE(n.truth.witness);
  });
}

// One-sided patches are separated by their plane, and most of the paper's are by one of theirs.
TEST(Generate, TheMovingPlaneThatProvesACaseIsPartOfItAndTheCheckerAcceptsIt) {
  int with_plane = 0, all = 0;
  for_each_case([&](const GeneratorOptions& options, std::uint64_t, const Generated& made) {
    const Case& c = made.value;
    ++all;
    with_plane += c.truth.clearance.has_value();
    if (options.construction == Construction::kPaper && !c.truth.clearance) return;
    ASSERT_TRUE(c.truth.clearance);
    const Result<void> checked = check_absence(c);
    EXPECT_TRUE(checked) << checked.error().message();
  });
  EXPECT_GT(with_plane, all / 2);
}

// Other cases may be made with another budget, so it is part of where they come from.
TEST(Generate, TheOriginNamesABudgetOfItsOwn) {
  GeneratorOptions options{.construction = Construction::kOneSided};
  EXPECT_EQ(generate(options, 0).value.origin.generator, "one-sided");
  options.proof_pops = 1000;
  EXPECT_EQ(generate(options, 0).value.origin.generator, "one-sided, proven in 1000 pops");
  options.family = Family::kScaled;  // which proves no absence
  EXPECT_EQ(generate(options, 0).value.origin.generator, "scaled");
  options.proof_pops = 0;
  EXPECT_EQ(validate(options).error().message(), "proof_pops: 0 is not at least 1");
}

// Section 5.4: "the discard rate of this test is 0 %".
TEST(Generate, EveryAttemptIsAcceptedOrDiscardedAndNoneForItsRoundTrip) {
  for_each_case([](const GeneratorOptions& options, std::uint64_t, const Generated& made) {
    EXPECT_EQ(made.discards.accepted(), 1u);
    EXPECT_EQ(made.discards[Discard::kRoundTrip], 0u);
    if (options.construction == Construction::kPaper) return;
    EXPECT_EQ(made.discards.attempts, 1u);
  });
}

TEST(Generate, MakesTheSameCasesOnEveryThread) {
  GeneratorOptions options{.contact = ContactClass::kVE};
  constexpr int kCases = 16;
  std::vector<Case> together(kCases);
  std::vector<std::thread> threads;
  for (int first = 0; first < 4; ++first) {
    threads.emplace_back([&, first] {
      for (int i = kCases - 4 + first; i >= 0; i -= 4) together[i] = generate(options, i).value;
    });
  }
  for (std::thread& thread : threads) thread.join();
  for (int i = 0; i < kCases; ++i) EXPECT_EQ(together[i], generate(options, i).value) << i;
}

TEST(Generate, DependsOnSeedAndIndex) {
  for_each_case([](const GeneratorOptions& options, std::uint64_t index, const Generated& made) {
    if (index > 0 || (kOneIn > 1 && options.kind != CaseKind::kRP)) return;
    EXPECT_NE(generate(options, index + 1).value.query, made.value.query);
    GeneratorOptions other = options;
    other.seed = 1;
    EXPECT_NE(generate(other, index).value.query, made.value.query);
  });
}

}  // namespace
}  // namespace ccdfuzz
