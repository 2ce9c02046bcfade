#include <gtest/gtest.h>

#include "process.hpp"

namespace ccdfuzz {
namespace {

std::string regression(const std::string& name) {
  return CCDFUZZ_SOURCE_DIR "/corpus/regressions/" + name + ".json";
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
  for (const std::vector<std::string>& what :
       {std::vector<std::string>{regression("tdibm-e-underflow")}, {"--generate", "2"}}) {
    std::vector<std::string> arguments = {"trace", "--methods", "tdibm," + naive};
    arguments.insert(arguments.end(), what.begin(), what.end());
    const Finished refused = ccdfuzz(arguments);
    EXPECT_EQ(refused.code, 2);
    EXPECT_NE(refused.err.find("cannot be traced"), std::string::npos) << refused.err;
    EXPECT_EQ(refused.out, "");
  }
}

TEST(Trace, TheTableHasARowForEachTrace) {
  const ScratchFolder folder;
  const std::string single = folder / "single.json";
  write_text(single, head_on("1", R"(,"truth":{"collides":true,)" + kWitness + "}"));
  const Finished finished = ccdfuzz({"trace", single, "--methods", "tdibm,trad", "--all"});
  EXPECT_EQ(finished.code, 0) << finished.err;
  EXPECT_EQ(std::ranges::count(finished.out, '\n'), 3);
  EXPECT_NE(finished.out.find("kept"), std::string::npos) << finished.out;
}

TEST(Trace, GeneratedCasesEndWith1IfAClaimIsBroken) {
  const auto generated_rows = [](const std::string& methods, int code) {
    const Finished finished = ccdfuzz({"trace", "--generate", "400", "--seed", "2", "--methods",
                                       methods, "--precision", "2^-6", "--json"});
    EXPECT_EQ(finished.code, code) << finished.err;
    return json_lines(finished.out);
  };
  const auto sound = generated_rows("tdibm-c", 0);
  ASSERT_EQ(sound.size(), 6U + 1);
  EXPECT_EQ(sound.back().at("cases"), 400);
  EXPECT_EQ(sound.back().at("lost"), 0);
  const auto broken = generated_rows("tdibm-c,tdibm-e", 1);
  ASSERT_GT(broken.size(), 12U + 1);
  EXPECT_EQ(broken.back().at("traces"), 800);
  EXPECT_EQ(broken.back().at("lost"), broken.size() - 13);
  EXPECT_EQ(broken.front().at("method"), "tdibm-e");
  const std::string again = broken.front().at("reproduce");
  const Finished repeated = shell(again + " --json");
  EXPECT_EQ(repeated.code, 1) << repeated.err;
  EXPECT_EQ(json_lines(repeated.out).front(), broken.front());
}

TEST(Trace, WritesTheCasesWhoseWitnessWasLost) {
  const ScratchFolder folder;
  const std::string lost = folder / "lost.jsonl", none = folder / "none.jsonl";
  const Finished plain = ccdfuzz({"trace", "--generate", "100", "--methods", "tdibm", "-o", lost});
  EXPECT_EQ(plain.code, 0) << plain.err << "it claims nothing";
  EXPECT_NE(plain.out.find("lost: case "), std::string::npos) << plain.out;
  const auto rows = json_lines(ccdfuzz({"trace", lost, "--methods", "tdibm", "--json"}).out);
  ASSERT_FALSE(rows.empty());
  for (const auto& row : rows) EXPECT_EQ(row.at("lost"), true);
  EXPECT_EQ(ccdfuzz({"trace", "--generate", "100", "--methods", "tdibm-c", "-o", none}).code, 0);
  EXPECT_FALSE(std::filesystem::exists(none)) << "nothing to write";
}

TEST(Trace, WrongUseEndsWith2) {
  EXPECT_EQ(ccdfuzz({"trace"}).code, 2);
  EXPECT_EQ(ccdfuzz({"trace", "x.json", "--generate", "3"}).code, 2);
  EXPECT_EQ(ccdfuzz({"trace", "x.json", "--seed", "3"}).code, 2);
  EXPECT_EQ(ccdfuzz({"trace", "--generate", "0"}).code, 2);
  EXPECT_EQ(ccdfuzz({"trace", "--generate", "3", "--first", "18446744073709551614"}).code, 2);
}

}  // namespace
}  // namespace ccdfuzz
