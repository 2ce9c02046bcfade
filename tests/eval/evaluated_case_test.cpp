#include "eval/evaluated_case.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "base/fields.hpp"
#include "eval/groups.hpp"
#include "eval/paper_tables.hpp"

namespace ccdfuzz {
namespace {

EvaluatedCase some_case() {
  EvaluatedCase one{3, "sets, \"new\"/vv.jsonl:4", "VV", "RP", true, {}};
  GivenAnswer& given = one.answers.emplace_back();
  given.factor = 1 + 0x1p-30;
  given.method = "tdibm-h:1e-12";
  given.t_max = 0.1;
  given.verdict = Verdict::kHit;
  given.toi = std::nextafter(0.1, 0);
  given.outcome = Outcome::kCorrect;
  given.pops = 17;
  given.bytes = 4096;
  given.seconds = 1.25e-6;
  return one;
}

TEST(EvaluatedCase, ReadsBackAsItWasWritten) {
  EvaluatedCase one = some_case();
  one.answers.push_back(one.answers[0]);
  for (const Outcome outcome : kAllOutcomes) {
    for (const Verdict verdict : {Verdict::kHit, Verdict::kMiss, Verdict::kUndecided}) {
      one.answers[1].outcome = outcome;
      one.answers[1].verdict = verdict;
      const auto back = from_json<EvaluatedCase>(to_json(one), "here");
      ASSERT_TRUE(back) << back.error().message();
      EXPECT_EQ(*back, one);
    }
  }
  one.collides.reset();
  one.answers[0].factor.reset();
  one.answers[0].toi.reset();
  EXPECT_EQ(from_json<EvaluatedCase>(to_json(one), "here").value(), one);
}

RC_GTEST_PROP(EvaluatedCase, EveryDoubleReadsBackAsItself, (double x, std::uint64_t n)) {
  EvaluatedCase one = some_case();
  one.answers[0].t_max = x;
  one.answers[0].toi = std::ldexp(x, -900);
  one.answers[0].pops = n;
  RC_ASSERT(from_json<EvaluatedCase>(to_json(one), "here").value() == one);
}

EvaluatedCase answer_to(const std::string& contact, const std::string& kind,
                        const std::string& method, Outcome outcome) {
  EvaluatedCase one = some_case();
  one.contact = contact;
  one.kind = kind;
  one.collides = kind == "RP" || kind == "NHP";
  one.answers[0].method = method;
  one.answers[0].factor.reset();
  one.answers[0].outcome = outcome;
  return one;
}

TEST(Groups, RegularAndGrazingAreApartAndTable1PutsThemTogether) {
  Groups groups;
  groups.add(answer_to("FF", "RP", "tdibm", Outcome::kCorrect));
  groups.add(answer_to("VV", "NHP", "tdibm-e", Outcome::kCorrect));
  groups.add(answer_to("VV", "NMN", "tdibm-e", Outcome::kFalsePositive));
  for (const char* method : {"tdibm-e", "tdibm"}) {
    groups.add(answer_to("VV", "RP", method, Outcome::kMissed));
    groups.add(answer_to("VV", "RN", method, Outcome::kCorrect));
    groups.add(answer_to("FF", "RN", method, Outcome::kCorrect));
  }
  const std::vector<EvaluatedGroup> all = groups.in_order();
  ASSERT_EQ(all.size(), 5U);
  EXPECT_EQ(all[0].contact, "FF");
  EXPECT_EQ(all[2].method, "tdibm");
  EXPECT_EQ(all[2].kinds, "RP+RN");
  EXPECT_EQ(all[4].kinds, "NHP+NMN");
  const std::vector<PaperComparison> table_1 = compare_with_table_1(all);
  ASSERT_EQ(table_1.size(), 4U);
  EXPECT_EQ(table_1[3].group.tally.n, 4U);
  EXPECT_EQ(table_1[3].group.tally.negatives, 2U);
  EXPECT_EQ(table_1[3].paper->false_positives.total, 1100U);
  const std::vector<PaperComparison> table_2 = compare_with_table_2(all);
  ASSERT_EQ(table_2.size(), 5U);
  EXPECT_EQ(table_2[4].paper->false_positives.total, 100U);
}

// Table 1's counts are the sums of Table 2's: what the paper prints of both.
TEST(PaperRates, TheHalvesOfTable2SumToTable1) {
  const auto sum = [](const char* contact, const char* method) {
    return paper_result(contact, "all", method).value();
  };
  EXPECT_EQ(sum("FF", "tdibm").false_positives.count, 175U);
  EXPECT_EQ(sum("FF", "tdibm").false_positives.total, 6603U);
  EXPECT_EQ(sum("FF", "trad").false_positives.total, 40U);
  EXPECT_EQ(sum("FF", "trad").false_negatives->total, 20U);
  EXPECT_EQ(sum("VE", "tdibm-h:1e-12").false_positives.count, 312U);
  EXPECT_EQ(sum("VE", "tdibm-e").false_positives.count, 310U);
  EXPECT_EQ(sum("VE", "trad").false_positives.count, 458U);
  EXPECT_EQ(sum("VV", "tdibm-h:1e-12").false_positives.count, 56U);
  EXPECT_EQ(sum("VV", "tdibm-h:1e-8").false_positives.count, 58U);
  EXPECT_EQ(sum("VV", "tdibm").false_negatives->count, 860U);
  EXPECT_EQ(sum("EE", "tdibm").false_positives.count, 121U);
  EXPECT_EQ(sum("EE", "trad").false_positives.count, 96U);
  EXPECT_FALSE(paper_result("FF", "NHP+NMN", "trad")->false_negatives);
  EXPECT_FALSE(paper_result("FF", "all", "tdibm-c"));
  EXPECT_FALSE(paper_result("curve", "all", "tdibm"));
}

}  // namespace
}  // namespace ccdfuzz
