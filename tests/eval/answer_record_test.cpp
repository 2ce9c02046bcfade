#include "eval/answer_record.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "base/csv.hpp"
#include "eval/groups.hpp"
#include "eval/paper_tables.hpp"

namespace ccdfuzz {
namespace {

AnswerRecord some_record() {
  AnswerRecord record;
  record.index = 3;
  record.id = "sets, \"new\"/vv.jsonl:4";
  record.contact = "VV";
  record.kind = "RP";
  record.collides = true;
  record.factor = 1 + 0x1p-30;
  record.method = "tdibm-h:1e-12";
  record.t_max = 0.1;
  record.verdict = Verdict::kHit;
  record.toi = std::nextafter(0.1, 0);
  record.outcome = Outcome::kCorrect;
  record.pops = 17;
  record.bytes = 4096;
  record.seconds = 1.25e-6;
  return record;
}

TEST(AnswerRecord, ReadsBackAsItWasWritten) {
  AnswerRecord record = some_record();
  for (const Outcome outcome : kAllOutcomes) {
    for (const Verdict verdict : {Verdict::kHit, Verdict::kMiss, Verdict::kUndecided}) {
      record.outcome = outcome;
      record.verdict = verdict;
      const auto back = from_csv_row<AnswerRecord>(csv_row(record), "here");
      ASSERT_TRUE(back) << back.error().message();
      EXPECT_EQ(*back, record);
    }
  }
  record.collides.reset();
  record.factor.reset();
  record.toi.reset();
  EXPECT_EQ(from_csv_row<AnswerRecord>(csv_row(record), "here").value(), record);
}

RC_GTEST_PROP(AnswerRecord, EveryDoubleReadsBackAsItself, (double x, std::uint64_t n)) {
  AnswerRecord record = some_record();
  record.t_max = x;
  record.toi = std::ldexp(x, -900);
  record.pops = n;
  RC_ASSERT(from_csv_row<AnswerRecord>(csv_row(record), "here").value() == record);
}

TEST(AnswerRecord, WhatIsNoneIsRefusedByColumn) {
  const std::string good = csv_row(some_record());
  const auto complaint = [](const std::string& line) {
    const auto parsed = from_csv_row<AnswerRecord>(line, "answers.csv:7");
    return parsed ? "" : parsed.error().message();
  };
  EXPECT_EQ(complaint(good), "");
  EXPECT_NE(complaint(good + ",1").find("answers.csv:7: has 15 fields"), std::string::npos);
  EXPECT_NE(complaint("x" + good).find("index: \"x3\""), std::string::npos);
  std::string other = good;
  EXPECT_NE(complaint(other.replace(other.find("correct"), 7, "corect")).find("outcome"),
            std::string::npos);
  other = good;
  EXPECT_NE(complaint(other.replace(other.find("true"), 4, "maybe")).find("collides"),
            std::string::npos);
}

AnswerRecord answer_to(const std::string& contact, const std::string& kind,
                       const std::string& method, Outcome outcome) {
  AnswerRecord record = some_record();
  record.contact = contact;
  record.kind = kind;
  record.method = method;
  record.collides = kind == "RP" || kind == "NHP";
  record.factor.reset();
  record.outcome = outcome;
  return record;
}

TEST(Groups, RegularAndGrazingAreApartAndTable1PutsThemTogether) {
  Groups groups({"tdibm", "tdibm-e"});
  groups.add(answer_to("VV", "NHP", "tdibm-e", Outcome::kCorrect));
  groups.add(answer_to("VV", "NMN", "tdibm-e", Outcome::kFalsePositive));
  for (const char* method : {"tdibm-e", "tdibm"}) {
    groups.add(answer_to("VV", "RP", method, Outcome::kMissed));
    groups.add(answer_to("VV", "RN", method, Outcome::kCorrect));
    groups.add(answer_to("FF", "RP", method, Outcome::kCorrect));
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
