#include <gtest/gtest.h>

#include "process.hpp"

namespace ccdfuzz {
namespace {

std::string regression(const std::string& name) {
  return CCDFUZZ_SOURCE_DIR "/corpus/cases/" + name + ".json";
}

/// Two points that meet at t = 1/2; `truth` is what the case says of that.
std::string head_on(const std::string& t_max, const std::string& truth) {
  return R"({"format":"ccdfuzz-case","version":1,"patches":[)"
         R"({"shape":"point","positions":[[0,0,0]],"velocities":[[1,0,0]]},)"
         R"({"shape":"point","positions":[[1,0,0]],"velocities":[[-1,0,0]]}],"t_max":)" +
         t_max + truth + "}";
}

const std::string kWitness = R"("witness":{"t":"1/2","uv":[["0","0"],["0","0"]]})";

TEST(Trace, RowsComeInOrderWithAllDetails) {
  const ScratchFolder folder;
  const std::string set = generated(folder, "VV", "RP", 3);
  const Finished finished =
      ccdfuzz({"trace", set, "--methods", "tdibm-c,tdibm-rational", "--json"});
  EXPECT_EQ(finished.code, 0) << finished.err;
  const auto rows = json_lines(finished.out);
  ASSERT_EQ(rows.size(), 6U);
  for (size_t i = 0; i < rows.size(); ++i) {
    EXPECT_EQ(rows[i].at("case"), fmt::format("{}:{}", set, i / 2 + 1));
    EXPECT_EQ(rows[i].at("method"), i % 2 == 0 ? "tdibm-c" : "tdibm-rational");
    EXPECT_EQ(rows[i].at("lost"), false);
    EXPECT_TRUE(rows[i].at("loss").is_null());
    EXPECT_EQ(rows[i].at("levels"), 14);
    const auto& margin = rows[i].at("margin");
    ASSERT_TRUE(margin.is_object());
    for (const char* key : {"ulps", "level", "axis", "direction", "below", "window", "excluded"}) {
      EXPECT_TRUE(margin.contains(key)) << key;
    }
    EXPECT_EQ(rows[i].at("slack").is_object(), i % 2 == 0);
  }
}

// The named entry was found at precision 1e-2, where origin.precision says so.
TEST(Trace, ACaseIsTracedAtThePrecisionItWasFoundAt) {
  const std::string entry = regression("tdibm-e-literal-twin-shield");
  const auto levels = [&](std::vector<std::string> more) {
    more.insert(more.begin(), {"trace", entry, "--methods", "tdibm-e-literal,tdibm-c", "--json"});
    const Finished finished = ccdfuzz(more);
    EXPECT_EQ(finished.code, 0) << finished.err;
    auto rows = json_lines(finished.out);
    EXPECT_EQ(rows.size(), 2U);
    EXPECT_EQ(rows.at(0).at("lost"), true);
    EXPECT_TRUE(rows.at(0).at("loss").at("axis").is_number());
    return rows.at(1).at("levels").get<int>();
  };
  EXPECT_EQ(levels({}), 7);
  EXPECT_EQ(levels({"--precision", "1e-3"}), 10);
}

TEST(Trace, ACaseWithoutAWitnessInItsStepIsAnErrorThatNamesIt) {
  const ScratchFolder folder;
  const std::string none = folder / "none.json", late = folder / "late.json";
  write_text(none, head_on("1", ""));
  write_text(late, head_on("0.25", R"(,"truth":{)" + kWitness + "}"));
  const Finished without = ccdfuzz({"trace", none});
  EXPECT_EQ(without.code, 2);
  EXPECT_NE(without.err.find(none + ": truth.witness: is missing"), std::string::npos)
      << without.err;
  const Finished past = ccdfuzz({"trace", late});
  EXPECT_EQ(past.code, 2);
  EXPECT_NE(past.err.find("1/2 is past t_max 0.25"), std::string::npos) << past.err;
  EXPECT_EQ(past.out, "");
}

TEST(Trace, AMethodThatCannotBeTracedIsBadInput) {
  const std::string naive = std::string("plugin:") + CCDFUZZ_TEST_NAIVE_PLUGIN;
  const Finished refused =
      ccdfuzz({"trace", "--methods", "tdibm," + naive, regression("tdibm-e-underflow")});
  EXPECT_EQ(refused.code, 2);
  EXPECT_NE(refused.err.find("cannot be traced"), std::string::npos) << refused.err;
  EXPECT_EQ(refused.out, "");
}

TEST(Trace, TheTableHasARowForEachTrace) {
  const ScratchFolder folder;
  const std::string single = folder / "single.json";
  write_text(single, head_on("1", R"(,"truth":{"collides":true,)" + kWitness + "}"));
  const Finished finished = ccdfuzz({"trace", single, "--methods", "tdibm,trad", "--all"});
  EXPECT_EQ(finished.code, 0) << finished.err;
  EXPECT_EQ(std::ranges::count(finished.out, '\n'), 7) << finished.out;
  EXPECT_NE(finished.out.find("kept"), std::string::npos) << finished.out;
}

TEST(Trace, WrongUseEndsWith2) {
  const Finished without_case = ccdfuzz({"trace"});
  EXPECT_EQ(without_case.code, 2);
  EXPECT_NE(without_case.err.find("case"), std::string::npos) << without_case.err;
}

}  // namespace
}  // namespace ccdfuzz
