#include "eval/rows.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "eval/paper_rates.hpp"
#include "eval/tables.hpp"
#include "io/fields.hpp"

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
  given.cost.pops = 17;
  given.cost.bytes = 4096;
  given.cost.seconds = 1.25e-6;
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
  one.answers[0].cost.pops = n;
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

TEST(Rows, RegularAndGrazingAreApartAndTable1PutsThemTogether) {
  Rows rows;
  rows.add(answer_to("FF", "RP", "tdibm", Outcome::kCorrect));
  rows.add(answer_to("VV", "NHP", "tdibm-e", Outcome::kCorrect));
  rows.add(answer_to("VV", "NMN", "tdibm-e", Outcome::kFalsePositive));
  for (const char* method : {"tdibm-e", "tdibm"}) {
    rows.add(answer_to("VV", "RP", method, Outcome::kMissed));
    rows.add(answer_to("VV", "RN", method, Outcome::kCorrect));
    rows.add(answer_to("FF", "RN", method, Outcome::kCorrect));
  }
  EXPECT_EQ(rows.in_order().size(), 9U);
  const std::vector<Row> all = by_kinds(rows);
  ASSERT_EQ(all.size(), 5U);
  EXPECT_EQ(all[0].key.contact, "FF");
  EXPECT_EQ(all[2].key.method, "tdibm");
  EXPECT_EQ(all[2].key.kind, "RP+RN");
  EXPECT_EQ(all[4].key.kind, "NHP+NMN");
  const auto table_1 = paper_table_1(rows).texts(), table_2 = paper_table_2(rows).texts();
  ASSERT_EQ(table_1.size(), 4U);
  EXPECT_EQ(table_1[3][1], "all");
  EXPECT_EQ(table_1[3][7], "1/2 = 50.0 %");  // tdibm-e: of RN and NMN
  EXPECT_NE(table_1[3][8].find("/1100"), std::string::npos);
  ASSERT_EQ(table_2.size(), 5U);
  EXPECT_NE(table_2[4][8].find("/100 "), std::string::npos);
  EXPECT_EQ(evaluation_tables(rows, {})[1].note.find("certificate"), std::string::npos);
  EvaluatedCase unproven = answer_to("VV", "RN", "tdibm", Outcome::kUnknown);
  unproven.collides.reset();
  rows.add(unproven);
  EXPECT_NE(evaluation_tables(rows, {})[1].note.find("certificate: 1;"), std::string::npos);
  Rows half;
  half.add(answer_to("FF", "RP", "tdibm", Outcome::kCorrect));
  EXPECT_EQ(paper_table_1(half).row_count(), 0U);
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
