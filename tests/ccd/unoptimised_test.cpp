#include "ccd/unoptimised.hpp"

#include <gtest/gtest.h>

#include "generators/generate.hpp"
#include "planted.hpp"
#include "share.hpp"

namespace ccdfuzz {
namespace {

constexpr std::uint64_t kPerFamily = 5, kPerPairOfShapes = 2;
/// Both forms are templates, slow without optimisation: fewer still are looked at then.
constexpr std::size_t kComparedOneIn = kOneIn == 1 ? 1 : 3 * kOneIn;

/// Cases of every contact class and family, at and past the contact; then planted
/// contacts of every pair of shapes.
std::vector<Query> mixed_queries() {
  std::vector<Query> queries;
  size_t next = 0;
  const auto is_wanted = [&next] { return next++ % kComparedOneIn == 0; };
  for (const ContactClass contact : kContactClasses) {
    for (const Family family : kFamilies) {
      if (!is_made(family, contact, CaseKind::kRP)) continue;
      for (std::uint64_t index = 0; index < kPerFamily; ++index) {
        if (!is_wanted()) continue;
        GeneratorOptions options;
        options.contact = contact;
        options.family = family;
        options.construction = index % 2 == 0 ? Construction::kPaper : Construction::kOneSided;
        options.seed = 11;
        queries.push_back(generate(options, index).value.query);
        queries.push_back(queries.back());
        queries.back().t_max *= 1.5;
      }
    }
  }
  for (const Shape& a : kSomeShapes) {
    for (const Shape& b : kSomeShapes) {
      for (std::uint64_t index = 0; index < kPerPairOfShapes; ++index) {
        if (!is_wanted()) continue;
        Draw random{Random::keyed({static_cast<std::uint64_t>(a.control_count()),
                                   static_cast<std::uint64_t>(b.control_count()), index, 7})};
        queries.push_back(plant_contact(random, a, b).query);
      }
    }
  }
  Draw random{Random::keyed({8})};
  const int degree = kOneIn == 1 ? 8 : 4;
  queries.push_back(
      plant_contact(random, Shape::tensor(degree, degree), Shape::triangle(degree)).query);
  return queries;
}

std::string describe(const Query& query, size_t index) {
  return "query " + std::to_string(index) + ", " + to_text(query.patches[0].shape) + " against " +
         to_text(query.patches[1].shape);
}

/// The claim: not one bit of an answer depends on the form. So few pops suffice to compare every
/// window there is on the way.
template <class Policy>
class Unoptimised : public testing::Test {
 public:
  static Policy policy() {
    if constexpr (std::is_default_constructible_v<Policy>) {
      return Policy();
    } else {
      return Policy(1e-12);
    }
  }
};

using Policies = testing::Types<Plain, PullApart, ErrorBoundIntended, ErrorBoundPrinted>;
TYPED_TEST_SUITE(Unoptimised, Policies);

TYPED_TEST(Unoptimised, AnswersBitForBitTheSame) {
  static const std::vector<Query> queries = mixed_queries();
  Tdibm<TypeParam> optimised(this->policy());
  UnoptimisedTdibm<TypeParam> unoptimised(this->policy());
  SearchOptions options;
  options.precision = 0x1p-6;
  options.max_pops = 20;
  size_t hits = 0, misses = 0;
  for (size_t i = 0; i < queries.size(); ++i) {
    const Answer fast = optimised.answer(queries[i], options);
    const Answer slow = unoptimised.answer(queries[i], options);
    ASSERT_EQ(fast.verdict, slow.verdict) << describe(queries[i], i);
    ASSERT_EQ(fast.toi, slow.toi) << describe(queries[i], i);
    ASSERT_EQ(fast.uv, slow.uv) << describe(queries[i], i);
    ASSERT_EQ(fast.pops, slow.pops) << describe(queries[i], i);
    hits += fast.verdict == Verdict::kHit ? 1 : 0;
    misses += fast.verdict == Verdict::kMiss ? 1 : 0;
  }
  EXPECT_GE(queries.size(), 400U / kComparedOneIn);  // 2,000 comparisons over the five policies
  EXPECT_GT(hits, 100U / kComparedOneIn);
  if (kOneIn == 1) {
    EXPECT_GT(misses, 3U);
  }
}

}  // namespace
}  // namespace ccdfuzz
