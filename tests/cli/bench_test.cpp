#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "process.hpp"

namespace ccdfuzz {
namespace {

TEST(Bench, EveryClassHasARowForEachMethodAndTheFirstIsTheMeasure) {
  const Finished finished =
      succeeded(ccdfuzz({"bench", "--classes", "VV,VE", "--count", "2", "--seed", "3", "--methods",
                         "tdibm-c,tdibm-e,tdibm-e@unoptimised", "--json"}));
  const auto rows = json_lines(finished.out);
  ASSERT_EQ(rows.size(), 6U);
  for (size_t i = 0; i < rows.size(); ++i) {
    const auto& row = rows[i];
    const char* const methods[] = {"tdibm-c", "tdibm-e", "tdibm-e@unoptimised"};
    EXPECT_EQ(row["class"], i < 3 ? "VV" : "VE");
    EXPECT_EQ(row["method"], methods[i % 3]);
    EXPECT_EQ(row["base"], "tdibm-c");
    EXPECT_EQ(row["n"], 4);  // a positive and a negative of each case
    EXPECT_GT(row["pops"], 0);
    const auto& base = rows[i / 3 * 3];
    EXPECT_DOUBLE_EQ(row["total_ratio"].get<double>(),
                     row["total_seconds"].get<double>() / base["total_seconds"].get<double>());
  }
  // Both forms do the same search.
  EXPECT_EQ(rows[1]["pops"], rows[2]["pops"]);
}

TEST(Bench, OfMeshesAsksAPluginThatTakesThemAlone) {
  const std::string plugin = "plugin:" CCDFUZZ_TEST_LINEAR_PLUGIN;
  const std::vector<std::string> arguments = {"bench",     "--linear",          "--count", "2",
                                              "--methods", "tdibm-c," + plugin, "--json"};
  const auto rows = json_lines(succeeded(ccdfuzz(arguments)).out);
  ASSERT_EQ(rows.size(), 8U);  // of VF, EE, VE and VV
  for (const auto& row : rows) {
    const bool is_asked =
        row["method"] == "tdibm-c" || row["class"] == "VF" || row["class"] == "EE";
    EXPECT_EQ(row["n"], is_asked ? 4 : 0) << row;
  }
  refused(ccdfuzz(with(arguments, {"--classes", "VF,FF"})), "--classes: FF");
}

TEST(Bench, AQueryStopsAtTheBudgetAndTheTableSaysSo) {
  const std::vector<std::string> arguments = {
      "bench", "--classes", "EF",           "--count",    "1", "--seed",
      "1",     "--methods", "tdibm-c,trad", "--max-pops", "50"};
  const Finished finished = succeeded(ccdfuzz(arguments));
  EXPECT_THAT(finished.out, testing::HasSubstr("undecided, after 50 pops"));
  EXPECT_THAT(finished.out, testing::HasSubstr("≥ "));
}

TEST(Bench, AQueryStopsAtATimeLimit) {
  const std::vector<std::string> arguments = {
      "bench",  "--classes", "VV",   "--count",       "1",
      "--json", "--methods", "trad", "--max-seconds", "1e-6"};
  const auto rows = json_lines(ccdfuzz(arguments).out);
  ASSERT_EQ(rows.size(), 1U);
  EXPECT_GE(rows[0].at("undecided"), 1) << "no pair of boxes takes less than a microsecond";
}

}  // namespace
}  // namespace ccdfuzz
