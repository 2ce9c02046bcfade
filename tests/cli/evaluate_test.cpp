#include <gtest/gtest.h>

#include "process.hpp"

namespace ccdfuzz {
namespace {

TEST(Evaluate, CountsEveryAnswerOncePerClassAndMethod) {
  const ScratchFolder folder;
  const std::string vv = generated(folder, "VV", "RP", 8), ve = generated(folder, "VE", "RN", 5);
  const Finished finished = ccdfuzz({"evaluate", ve, vv, "--methods", "tdibm,tdibm-e", "--json"});
  EXPECT_EQ(finished.code, 0) << finished.err;
  const auto rows = json_lines(finished.out);
  ASSERT_EQ(rows.size(), 4U);
  const auto is = [&](size_t i, const char* contact, const char* method, int n) {
    EXPECT_EQ(rows[i].at("class"), contact);
    EXPECT_EQ(rows[i].at("method"), method);
    EXPECT_EQ(rows[i].at("n"), n);
    int sum = 0;
    for (const char* outcome :
         {"correct", "missed", "late", "false_positive", "undecided", "unknown", "error"}) {
      sum += rows[i].at(outcome).get<int>();
    }
    EXPECT_EQ(sum, n);
  };
  is(0, "VE", "tdibm", 5);
  is(1, "VE", "tdibm-e", 5);
  is(2, "VV", "tdibm", 8);
  is(3, "VV", "tdibm-e", 8);
  EXPECT_EQ(rows[0].at("negatives"), 5);
  EXPECT_EQ(rows[2].at("positives"), 8);
  EXPECT_EQ(rows[3].at("missed"), 0);
}

TEST(Evaluate, HorizonsAskPositiveCasesPastTheContactAndNegativeOnesAsTheyStand) {
  const ScratchFolder folder;
  const std::string vv = generated(folder, "VV", "RP", 3), rn = generated(folder, "VV", "RN", 2);
  const Finished finished = ccdfuzz(
      {"evaluate", vv, rn, "--methods", "tdibm-e", "--t-max-factors", "1,1+2^-30,1.5,2", "--json"});
  const auto rows = json_lines(finished.out);
  ASSERT_EQ(rows.size(), 5U);
  EXPECT_TRUE(rows[0].at("t_max_factor").is_null());
  EXPECT_EQ(rows[0].at("negatives"), 2);
  const std::vector<double> factors = {1, 1 + 0x1p-30, 1.5, 2};
  for (size_t i = 0; i < factors.size(); ++i) {
    EXPECT_EQ(rows[i + 1].at("t_max_factor"), factors[i]);
    EXPECT_EQ(rows[i + 1].at("positives"), 3);
    EXPECT_EQ(rows[i + 1].at("late"), 0);
  }
}

TEST(Evaluate, TheReportFolderHoldsEveryAnswerInOrder) {
  const ScratchFolder folder;
  const std::string set = generated(folder, "VV", "RP", 6), report = folder / "deep/report";
  const Finished finished =
      ccdfuzz({"evaluate", set, "--methods", "tdibm,tdibm-e", "-o", report, "--threads", "2"});
  EXPECT_EQ(finished.code, 0) << finished.err;
  std::istringstream answers(read_text(report + "/answers.csv"));
  std::string line;
  std::getline(answers, line);
  EXPECT_EQ(line, "case,class,kind,method,t_max,verdict,toi,outcome,pops,seconds");
  for (int i = 0; i < 12; ++i) {
    ASSERT_TRUE(std::getline(answers, line)) << i;
    const std::string begin =
        fmt::format("{}:{},VV,RP,{},", set, i / 2 + 1, i % 2 == 0 ? "tdibm" : "tdibm-e");
    EXPECT_EQ(line.substr(0, begin.size()), begin);
  }
  EXPECT_FALSE(std::getline(answers, line));
  EXPECT_NE(read_text(report + "/tables.md").find("| VV | tdibm |"), std::string::npos);
  EXPECT_EQ(json_lines(read_text(report + "/groups.jsonl")).size(), 2U);
  EXPECT_NE(read_text(report + "/performance.csv").find("class,t_max_factor,method,n,"),
            std::string::npos);
}

TEST(Evaluate, TheTableStandsBesideThePapersRates) {
  const ScratchFolder folder;
  const std::string set = generated(folder, "VE", "RN", 2);
  const Finished finished = ccdfuzz({"evaluate", set, "--methods", "tdibm"});
  EXPECT_NE(finished.out.find("223/1000 = 22.3 %"), std::string::npos) << finished.out;
  EXPECT_NE(finished.out.find("452/1000 = 45.2 %"), std::string::npos) << finished.out;
}

}  // namespace
}  // namespace ccdfuzz
