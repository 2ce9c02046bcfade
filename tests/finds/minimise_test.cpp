#include "finds/minimise.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "case/judge.hpp"
#include "ccd/tdibm.hpp"
#include "certify/checker/check_case.hpp"
#include "certify/checker/check_linear.hpp"
#include "certify/checker/check_truth.hpp"
#include "certify/oracle/decide_linear.hpp"
#include "certify/oracle/feature_depth.hpp"
#include "files/case_json.hpp"
#include "finds/content_address.hpp"
#include "generators/draw/draw.hpp"
#include "generators/generate.hpp"

namespace ccdfuzz {
namespace {

Case drawn(ContactClass contact, CaseKind kind, std::uint64_t index,
           Family family = Family::kRegular) {
  GeneratorOptions options{
      .contact = contact, .kind = kind, .construction = Construction::kOneSided, .family = family};
  return generate(options, index).value;
}

/// Says "no contact" to whatever has a velocity above 1/8 along z: a bug whose core is one number.
Answer misses_fast_ones(const Query& query) {
  for (const MovingPatch<double>& patch : query.patches) {
    for (const Vec3<double>& v : patch.velocities) {
      if (std::abs(v[2]) > 0.125) return Answer::miss();
    }
  }
  return Answer::hit(0);
}

bool is_missed(const Case& value) {
  return judge(checked_or_unknown(value), misses_fast_ones(value.query)) == Outcome::kMissed;
}

Case trimmed_contact() {
  Case found = drawn(ContactClass::kFF, CaseKind::kRP, 0);
  found.query.patches[0].trim = {{{0, 0}, {1, 0}, {0.5, 0.5}, {0, 1}},
                                 {{0.9375, 0}, {1, 0}, {0.9375, 0.0625}}};
  EXPECT_TRUE(check_truth(found));
  return found;
}

TEST(Minimise, TakesATrimAwayThatDoesNotMatter) {
  const Minimised small = minimise(trimmed_contact(), Outcome::kMissed, is_missed);
  EXPECT_FALSE(is_trimmed(small.value.query));
}

TEST(Minimise, LeavesATriangleOfATrimThatMatters) {
  const Minimised small = minimise(trimmed_contact(), Outcome::kMissed, [](const Case& c) {
    return check_truth(c) && is_trimmed(c.query);
  });
  ASSERT_TRUE(check_truth(small.value));
  const Trim& trim = small.value.query.patches[0].trim;
  ASSERT_EQ(trim.size(), 1U);
  EXPECT_EQ(trim[0].size(), 3U);
}

TEST(Minimise, FindsTheOneNumberThatMattersAndKeepsTheContact) {
  for (const ContactClass contact : kContactClasses) {
    // Its parameters have few bits. The contact's place stays, so those of others are left.
    const Case found = drawn(contact, CaseKind::kRP, 0, Family::kFlatGrazing);
    ASSERT_TRUE(is_missed(found));
    const Minimised small = minimise(found, Outcome::kMissed, [](const Case& c) {
      EXPECT_TRUE(check_truth(c)) << to_json(c);
      return is_missed(c);
    });
    EXPECT_TRUE(is_missed(small.value));
    EXPECT_TRUE(check_truth(small.value)) << to_json(small.value);
    EXPECT_EQ(small.value.origin, found.origin);
    EXPECT_GT(small.value.truth.witness->t, 0);
    // t_max, a velocity, and what brings the patches together in spite of it.
    EXPECT_LE(size_of(small.value.query).significant_bits, 8U) << to_json(small.value);
    EXPECT_GT(small.trials, 0U);
  }
}

TEST(Minimise, StopsWhenTold) {
  const Case found = drawn(ContactClass::kVF, CaseKind::kRP, 1);
  const Minimised few = minimise(found, Outcome::kMissed, is_missed, {3, [] { return false; }});
  EXPECT_EQ(few.trials, 3U);
  EXPECT_TRUE(is_missed(few.value));
  const Minimised none = minimise(found, Outcome::kMissed, is_missed, {1000, [] { return true; }});
  EXPECT_EQ(none.trials, 0U);
  EXPECT_EQ(none.value, found);
}

/// From the highest bit of a number to the lowest that is set.
std::uint64_t significant_bits(double x) {
  Query of_it;
  of_it.t_max = x;
  return size_of(of_it).significant_bits;
}

/// Of all coordinates that are not 0.
std::uint64_t median_bits(const Query& query) {
  std::vector<std::uint64_t> bits;
  for (const MovingPatch<double>& patch : query.patches) {
    for_each_coordinate(patch, [&](double x) {
      if (x != 0) bits.push_back(significant_bits(x));
    });
  }
  if (bits.empty()) return 0;
  const auto middle = bits.begin() + static_cast<std::ptrdiff_t>(bits.size() / 2);
  std::nth_element(bits.begin(), middle, bits.end());
  return *middle;
}

TEST(Minimise, CounterexamplesOfTdibmShrinkToSeventeenBitsACoordinate) {
  Tdibm<Plain> method{Plain()};
  SearchOptions search;
  search.max_pops = 10000;
  const auto outcome = [&](const Case& c) {
    return judge(checked_or_unknown(c), method.answer(c.query, search));
  };
  int found = 0;
  for (const ContactClass contact : {ContactClass::kVV, ContactClass::kVE, ContactClass::kVF}) {
    for (std::uint64_t index = 0; index < 6; ++index) {
      const Case drawn_case = drawn(contact, CaseKind::kRP, index);
      const Outcome failure = outcome(drawn_case);
      if (!is_false_negative(failure)) continue;
      ++found;
      const Minimised small =
          minimise(drawn_case, failure, [&](const Case& c) { return outcome(c) == failure; });
      EXPECT_EQ(outcome(small.value), failure);
      EXPECT_TRUE(check_truth(small.value)) << to_json(small.value);
      EXPECT_LE(median_bits(small.value.query), 17U) << to_json(small.value);
    }
  }
  EXPECT_GE(found, 6);
}

TEST(Minimise, LinearPatchesWithoutAWitnessKeepAContactThatIsDecided) {
  // The vertex passes the plane of the triangle at a root of 3t² − 1, which turns meanwhile.
  Case found;
  found.query.patches[0] = {Shape::point(), {{0.1, 0.3, -0.7}}, {{0.2, 0.1, 1.3}}};
  found.query.patches[1] = {Shape::triangle(1),
                            {{-3.1, -2.9, 0.1}, {3.3, -2.7, 0.2}, {0.1, 4.9, -0.1}},
                            {{0.1, 0.2, -0.3}, {-0.1, 0.1, 0.7}, {0.3, -0.1, -0.2}}};
  found.truth = decide_linear(found.query, {}).truth;
  ASSERT_EQ(found.truth.collides, true);
  ASSERT_FALSE(found.truth.witness.has_value());
  const Minimised small = minimise(found, Outcome::kMissed, [](const Case& c) {
    EXPECT_EQ(c.truth.collides, true);
    EXPECT_TRUE(check_case(c)) << to_json(c);
    return c.query.patches[0].velocities[0][2] > 1;
  });
  EXPECT_LT(size_of(small.value.query).significant_bits, 40U) << to_json(small.value);
  EXPECT_GT(size_of(found.query).significant_bits, 500U);
}

TEST(Minimise, LeavesWhatDoesNotFailWhenSimpler) {
  const Case found = drawn(ContactClass::kEE, CaseKind::kRP, 2);
  const auto only_this = [&](const Case& c) { return c.query == found.query; };
  EXPECT_EQ(minimise(found, Outcome::kMissed, only_this).value, found);
}

/// A point that passes a triangle at a distance, in numbers of many bits.
Case passing_point() {
  Draw random{Random(7)};
  const auto any = [&random] {
    return std::ldexp(static_cast<double>(random.integer(-(1 << 30), 1 << 30)), -30);
  };
  Case passing;
  passing.query.patches[0].shape = Shape::point();
  passing.query.patches[1].shape = Shape::triangle(1);
  for (MovingPatch<double>& patch : passing.query.patches) {
    for (int i = 0; i < patch.shape.control_count(); ++i) {
      patch.positions.emplace_back(any(), any(), any());
      patch.velocities.emplace_back(any(), any(), any());
    }
  }
  for (Vec3<double>& p : passing.query.patches[1].positions) p[2] += 8;
  passing.truth = decide_linear(passing.query, {}).truth;
  return passing;
}

TEST(Minimise, AFalsePositiveStaysOneWithProof) {
  const Case found = passing_point();
  ASSERT_EQ(found.truth.collides, false);
  const auto hits = [](const Case& c) {
    EXPECT_EQ(c.truth.collides, false);
    return c.query.patches[0].velocities[0][0] != 0;  // a method that hits whatever moves
  };
  const Minimised small = minimise(found, Outcome::kFalsePositive, hits);
  EXPECT_TRUE(hits(small.value));
  EXPECT_TRUE(check_truth(small.value));
  EXPECT_EQ(small.value.truth.proof, "L");
  EXPECT_TRUE(check_case(small.value)->is_clear());
  EXPECT_LE(size_of(small.value.query).significant_bits, 8U) << to_json(small.value);
  Tdibm<Plain> method{Plain()};
  EXPECT_EQ(method.answer(small.value.query, {}).verdict, Verdict::kMiss);
}

TEST(Minimise, AFalsePositiveOfCurvedPatchesKeepsAPlane) {
  const Case found = drawn(ContactClass::kFF, CaseKind::kRN, 0);
  ASSERT_EQ(found.truth.collides, false);
  ASSERT_EQ(found.truth.proof, "P");
  const Minimised small = minimise(found, Outcome::kFalsePositive, [](const Case& c) {
    return !is_linear_query(c.query) && c.query.patches[0].velocities[0][0] != 0;
  });
  EXPECT_EQ(small.value.truth.proof, "P");
  EXPECT_TRUE(check_case(small.value)->is_clear());
  EXPECT_GT(small.value.query.t_max, 0);
  EXPECT_LE(size_of(small.value.query).significant_bits, 12U) << to_json(small.value);
}

TEST(Minimise, ACurvedMissAtASeparationStaysApartByIt) {
  const Case found = drawn(ContactClass::kFF, CaseKind::kRP, 0, Family::kApart);
  ASSERT_GT(found.query.separation, 0);
  const Minimised small = minimise(found, Outcome::kMissed, [](const Case& c) {
    Case touching = c;
    touching.query.separation = 0;
    return check_truth(c) && !check_truth(touching) && !is_linear_query(c.query);
  });
  EXPECT_TRUE(check_truth(small.value));
  EXPECT_LE(size_of(small.value.query).significant_bits, 24U) << to_json(small.value);
}

TEST(Minimise, AnErrorNeedsNoTruth) {
  const Case found = drawn(ContactClass::kFF, CaseKind::kRP, 0);
  const Minimised small = minimise(found, Outcome::kError, [](const Case& c) {
    return c.query.patches[1].shape.kind == ShapeKind::kTriangle;
  });
  EXPECT_EQ(small.value.truth, Truth());
  EXPECT_EQ(small.value.query.patches[0].shape, Shape::point());
  EXPECT_EQ(small.value.query.patches[1].shape, Shape::triangle(1));
  EXPECT_LE(size_of(small.value.query).significant_bits, 1U) << to_json(small.value);
}

TEST(Minimise, WeightsThatDoNotMatterGoTo1) {
  Case found = drawn(ContactClass::kEE, CaseKind::kRP, 0);
  found.query.patches[0] = {Shape::curve(2), {{0, 0, 0}, {1, 0, 0}, {2, 1, 0}}, {}};
  found.query.patches[0].velocities.resize(3);
  found.query.patches[0].weights = {2, 7, 0.25};
  const Minimised small = minimise(found, Outcome::kError, [](const Case& c) {
    const MovingPatch<double>& patch = c.query.patches[0];
    return patch.shape == Shape::curve(2) && !patch.weights.empty() && patch.weights[1] > 2;
  });
  EXPECT_EQ(small.value.query.patches[0].weights, (std::vector<double>{1, 8, 1}));
}

TEST(Minimise, AnErrorOfBodiesStaysACastThatGoesSomewhere) {
  const Case found = drawn(ContactClass::kVF, CaseKind::kRP, 0, Family::kBodies);
  const Minimised small = minimise(found, Outcome::kError, [](const Case&) { return true; });
  EXPECT_GT(small.value.query.t_max, 0) << to_json(small.value);
}

struct MissesAll : Method {
  Answered answer(const Query&, const SearchOptions&) override { return {Answer::miss()}; }
};

Asker asker_of_misses() {
  return Asker({}, MethodSet([](const std::string&) -> Result<std::unique_ptr<Method>> {
                 return std::make_unique<MissesAll>();
               }));
}

double largest(const Query& query) {
  double most = 0;
  for (const MovingPatch<double>& patch : query.patches) {
    for (const Vec3<double>& p : patch.positions) most = std::max(most, p.cwiseAbs().maxCoeff());
  }
  return most;
}

double relative_depth(const Case& known) {
  return feature_depth(known, known.query.t_max) / largest(known.query);
}

TEST(Minimise, ADeepMissStaysHalfAsDeepAsTheDeepestFormTaken) {
  GeneratorOptions options{.contact = ContactClass::kVF,
                           .construction = Construction::kOneSided,
                           .shapes = {{Shape::point(), Shape::triangle(1)}}};
  Asker asker = asker_of_misses();
  int deep_ones = 0;
  for (std::uint64_t index = 0; index < 6; ++index) {
    Case found = generate(options, index).value;
    found.query.t_max *= 1.5;
    const Judged judged = asker.ask("tdibm", checked_or_unknown(found));
    const Failure failure = asker.failure("tdibm", found, judged).value();
    double deepest = relative_depth(found);
    deep_ones += deepest > 0 ? 1 : 0;
    for (const std::uint64_t trials : {4, 8, 16, 32, 64}) {
      const Case taken = minimise(found, failure, asker, {.max_trials = trials}).value;
      deepest = std::max(deepest, relative_depth(taken));
    }
    const Case small = minimise(found, failure, asker).value;
    EXPECT_GE(relative_depth(small), deepest / 2) << index;
    EXPECT_LT(size_of(small.query), size_of(found.query));
    const CheckedCase known = checked_or_unknown(small);
    EXPECT_EQ(depth_of(known, asker.ask("tdibm", known)).value_or(0),
              feature_depth(small, small.query.t_max));
  }
  EXPECT_GE(deep_ones, 3);
}

}  // namespace
}  // namespace ccdfuzz
