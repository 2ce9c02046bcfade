#include "generators/generate.hpp"
#include "certify/checker/check_case.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <bit>
#include <thread>

#include "ccd/rational/proves_clear.hpp"
#include "certify/checker/check_truth.hpp"
#include "certify/checker/check_witness.hpp"
#include "generators/prescribe.hpp"
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
        GeneratorOptions options;
        options.contact = contact;
        options.kind = kind;
        options.construction = construction;
        for (std::uint64_t index = 0; index < kCasesPerClass; ++index) {
          SCOPED_TRACE(describe(options, index));
          check(options, index, generate(options, index));
        }
      }
    }
  }
}

Feature feature_of(const Uv<Rational>& uv) {
  const Rational w = 1 - uv[0] - uv[1];
  const int zeros = (uv[0] == 0) + (uv[1] == 0) + (w == 0);
  return zeros == 0 ? Feature::kFace : zeros == 1 ? Feature::kEdge : Feature::kCorner;
}

TEST(Generate, GivesValidQueriesOfTriangularQuadratics) {
  for_each_case([](const GeneratorOptions&, std::uint64_t, const Generated& made) {
    const Case& c = made.value;
    EXPECT_TRUE(validate(c.query, ""));
    for (const MovingPatch<double>& patch : c.query.patches) {
      EXPECT_EQ(patch.shape, Shape::triangle(2));
    }
  });
}

TEST(Generate, PositivesCarryAWitnessAtTheEndOfTheirHorizon) {
  for_each_case([](const GeneratorOptions& options, std::uint64_t, const Generated& made) {
    if (options.kind != CaseKind::kRP) return;
    const Case& c = made.value;
    ASSERT_EQ(c.truth.collides, true);
    ASSERT_TRUE(c.truth.witness);
    const Result<void> checked = check_witness(c.query, *c.truth.witness);
    EXPECT_TRUE(checked) << checked.error().message();
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

// Also where a moving plane has proven it: two proofs that share no code must agree.
TEST(Generate, NothingTouchesBeforeClearUntil) {
  for_each_case([](const GeneratorOptions& options, std::uint64_t, const Generated& made) {
    if (options.kind != CaseKind::kRP) return;
    const Truth& truth = made.value.truth;
    const Rational before = truth.witness->t - power_of_two(-20);
    EXPECT_TRUE(proves_clear(made.value.query, std::min(*truth.clear_until, before)));
  });
}

TEST(Generate, TheContactLiesOnTheFeaturesThatItsClassNames) {
  for_each_case([](const GeneratorOptions& options, std::uint64_t, const Generated& made) {
    if (options.kind != CaseKind::kRP) return;
    const std::array<Feature, 2> wanted = features_of(options.contact);
    for (size_t s = 0; s < 2; ++s) {
      EXPECT_EQ(feature_of(made.value.truth.witness->uv[s]), wanted[s]) << "patch " << s;
    }
  });
}

TEST(Generate, FillsTheOrigin) {
  for_each_case([](const GeneratorOptions& options, std::uint64_t index, const Generated& made) {
    const Origin& origin = made.value.origin;
    EXPECT_EQ(origin.contact, name_of(options.contact));
    EXPECT_EQ(origin.kind, name_of(options.kind));
    EXPECT_EQ(origin.generator,
              options.construction == Construction::kPaper ? "paper" : "one-sided");
    EXPECT_EQ(origin.seed, options.seed);
    EXPECT_EQ(origin.index, index);
    EXPECT_FALSE(origin.ccdfuzz.empty());
  });
}

// Other cases may be made with another budget, so it is part of where they come from.
TEST(Generate, TheOriginNamesABudgetOfItsOwn) {
  GeneratorOptions options;
  options.construction = Construction::kOneSided;
  EXPECT_EQ(generate(options, 0).value.origin.generator, "one-sided");
  options.proof_pops = 1000;
  EXPECT_EQ(generate(options, 0).value.origin.generator, "one-sided, proven in 1000 pops");
  options.family = Family::kScaled;  // which proves no absence
  EXPECT_EQ(generate(options, 0).value.origin.generator, "scaled");
}

TEST(Generate, EveryAttemptIsAcceptedOrDiscardedForOneReason) {
  for_each_case([](const GeneratorOptions&, std::uint64_t, const Generated& made) {
    EXPECT_EQ(made.discards.accepted(), 1u);
    EXPECT_GE(made.discards.attempts, 1u);
  });
}

// Section 5.4: "the discard rate of this test is 0 %".
TEST(Generate, TheRoundTripDiscardsNothing) {
  for_each_case([](const GeneratorOptions&, std::uint64_t, const Generated& made) {
    EXPECT_EQ(made.discards[Discard::kRoundTrip], 0u);
  });
}

TEST(Generate, TheOneSidedFamilyDiscardsNothing) {
  for_each_case([](const GeneratorOptions& options, std::uint64_t, const Generated& made) {
    if (options.construction != Construction::kOneSided) return;
    DiscardCounts none;
    none.attempts = 1;
    EXPECT_EQ(made.discards, none);
  });
}

/// FNV-1a over the bits of every number of a case.
std::uint64_t fingerprint(std::uint64_t hash, const Case& c) {
  const auto add = [&hash](std::uint64_t word) {
    for (int shift = 0; shift < 64; shift += 8) {
      hash = (hash ^ ((word >> shift) & 0xff)) * 0x100000001b3;
    }
  };
  for (const MovingPatch<double>& patch : c.query.patches) {
    for (const Points<double>* points : {&patch.positions, &patch.velocities}) {
      for (const Vec3<double>& p : *points) {
        for (int k = 0; k < 3; ++k) add(std::bit_cast<std::uint64_t>(p[k]));
      }
    }
  }
  add(std::bit_cast<std::uint64_t>(c.query.t_max));
  return hash;
}

// One number for all compilers, libraries and thread counts. It changes with the generators, and
// only with them: put in the new one when you mean to change what they make.
TEST(Generate, MakesTheSameCasesEverywhere) {
  std::uint64_t first = 0xcbf29ce484222325, all = first;
  for_each_case([&](const GeneratorOptions&, std::uint64_t index, const Generated& made) {
    if (index == 0) first = fingerprint(first, made.value);
    all = fingerprint(all, made.value);
  });
  EXPECT_EQ(first, 0x02f0f3e4ccf31265u) << fmt::format("{:#x}", first);
  if (kOneIn > 1) return;  // only the first of each were made
  EXPECT_EQ(all, 0x7b7c57f4c46acf81u) << fmt::format("{:#x}", all);
}

TEST(Generate, MakesTheSameCasesOnEveryThread) {
  GeneratorOptions options;
  options.contact = ContactClass::kVE;
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

TEST(Generate, DependsOnOptionsAndIndexAlone) {
  for_each_case([](const GeneratorOptions& options, std::uint64_t index, const Generated& made) {
    if (index > 0 || (kOneIn > 1 && options.kind != CaseKind::kRP)) return;
    EXPECT_EQ(generate(options, index).value, made.value);
    EXPECT_NE(generate(options, index + 1).value.query, made.value.query);
    GeneratorOptions other = options;
    other.seed = 1;
    EXPECT_NE(generate(other, index).value.query, made.value.query);
  });
}

TEST(Generate, RefusesWhatItDoesNotMake) {
  GeneratorOptions options;
  options.kind = CaseKind::kNHP;
  options.family = Family::kTwins;
  const Result<void> kind = validate(options);
  ASSERT_FALSE(kind);
  EXPECT_EQ(kind.error().message(), "--kind: NHP is not generated in the family twins");
  options = {};
  options.eps_t_exponent = 0;
  const Result<void> eps = validate(options);
  ASSERT_FALSE(eps);
  EXPECT_EQ(eps.error().message(), "--eps-t: 2^0 is not in [2^-40, 2^-1]");
  options = {};
  options.proof_pops = 0;
  const Result<void> pops = validate(options);
  ASSERT_FALSE(pops);
  EXPECT_EQ(pops.error().message(), "proof_pops: 0 is not at least 1");
}

}  // namespace
}  // namespace ccdfuzz
