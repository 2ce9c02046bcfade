#include <gtest/gtest.h>

#include "process.hpp"

namespace ccdfuzz {
namespace {

/// Two points that meet at t = 1/2, with the witness that proves it.
std::string head_on(const std::string& t_max) {
  return R"({"format":"ccdfuzz-case","version":2,"patches":[)"
         R"({"shape":"point","positions":[[0,0,0]],"velocities":[[1,0,0]]},)"
         R"({"shape":"point","positions":[[1,0,0]],"velocities":[[-1,0,0]]}],"t_max":)" +
         t_max + R"(,"truth":{"collides":true,"witness":{"t":"1/2","uv":[["0","0"],["0","0"]]}}})";
}

TEST(Query, RowsComeInTheOrderOfCasesAndMethodsWithExactlyTheseKeys) {
  const ScratchFolder folder;
  const std::string set = generated(folder, "VV", "RP", 4);
  const std::string single = folder / "single.json";
  write_text(single, head_on("1"));
  const Finished finished =
      ccdfuzz({"query", set, single, "--methods", "tdibm-rational,tdibm", "--json"});
  EXPECT_EQ(finished.code, 0) << finished.err;
  const auto rows = json_lines(finished.out);
  ASSERT_EQ(rows.size(), 10U);
  for (size_t i = 0; i < rows.size(); ++i) {
    const std::string id = i < 8 ? fmt::format("{}:{}", set, i / 2 + 1) : single;
    EXPECT_EQ(rows[i].at("case"), id);
    EXPECT_EQ(rows[i].at("method"), i % 2 == 0 ? "tdibm-rational" : "tdibm");
    std::vector<std::string> keys;
    for (const auto& [key, value] : rows[i].items()) keys.push_back(key);
    EXPECT_EQ(keys, (std::vector<std::string>{"case", "method", "verdict", "toi", "uv", "outcome",
                                              "pops", "seconds"}));
    if (rows[i].at("verdict") == "hit") {
      EXPECT_TRUE(rows[i].at("toi").is_number());
      EXPECT_EQ(rows[i].at("uv").size(), 2U);
    } else {
      EXPECT_TRUE(rows[i].at("toi").is_null());
      EXPECT_TRUE(rows[i].at("uv").is_null());
    }
  }
  EXPECT_EQ(rows[8].at("outcome"), "correct");
}

TEST(Query, AnUndecidedAnswerSaysWhyAndExits0) {
  const ScratchFolder folder;
  const std::string set = generated(folder, "FF", "RP", 1);
  const Finished finished =
      ccdfuzz({"query", set, "--methods", "tdibm-e", "--max-pops", "2", "--json"});
  EXPECT_EQ(finished.code, 0) << finished.err;
  const auto rows = json_lines(finished.out);
  ASSERT_EQ(rows.size(), 1U);
  EXPECT_EQ(rows[0].at("verdict"), "undecided");
  EXPECT_EQ(rows[0].at("outcome"), "undecided");
  EXPECT_TRUE(rows[0].at("toi").is_number());
  EXPECT_NE(rows[0].at("note").get<std::string>().find("budget"), std::string::npos);
}

TEST(Query, ACaseIsAskedAtThePrecisionThatItWasFoundAt) {
  const ScratchFolder folder;
  const std::string path = folder / "single.json";
  const auto pops = [&](const std::string& asked, const std::vector<std::string>& flags) {
    std::string text = head_on("1");
    text.insert(text.rfind('}'), asked);
    write_text(path, text);
    std::vector<std::string> arguments = {"query", path, "--methods", "tdibm", "--json"};
    arguments.insert(arguments.end(), flags.begin(), flags.end());
    const Finished finished = ccdfuzz(arguments);
    EXPECT_EQ(finished.code, 0) << finished.err;
    const auto rows = json_lines(finished.out);
    return rows.empty() ? 0 : rows[0].at("pops").get<int>();
  };
  const std::string coarse = R"(,"asked":{"precision":0.25})";
  EXPECT_LT(pops(coarse, {}), pops("", {}));
  EXPECT_EQ(pops(coarse, {"--precision", "1e-4"}), pops("", {}));
  EXPECT_EQ(pops(R"(,"asked":{"max_pops":3})", {}), 3);
}

TEST(Query, PrintsTheRowsBeforeTheFirstBadInput) {
  const ScratchFolder folder;
  const std::string good = folder / "good.json", bad = folder / "bad.json";
  write_text(good, head_on("1"));
  write_text(bad, head_on("-1"));
  const Finished finished = ccdfuzz({"query", good, bad, good, "--methods", "tdibm", "--json"});
  EXPECT_EQ(finished.code, 2);
  EXPECT_EQ(json_lines(finished.out).size(), 1U) << finished.out;
  EXPECT_NE(finished.err.find(bad), std::string::npos) << finished.err;
  EXPECT_NE(finished.err.find("t_max"), std::string::npos) << finished.err;
}

TEST(Query, AnswersDoNotDependOnTheNumberOfThreads) {
  const ScratchFolder folder;
  const std::string set = generated(folder, "VE", "RP", 12);
  std::vector<std::string> outputs;
  for (const char* threads : {"1", "2", "5"}) {
    auto rows = json_lines(ccdfuzz({"query", set, "--json", "--threads", threads}).out);
    std::string all;
    for (auto& row : rows) {
      row.erase("seconds");
      all += row.dump() + "\n";
    }
    outputs.push_back(all);
  }
  EXPECT_FALSE(outputs[0].empty());
  EXPECT_EQ(outputs[0], outputs[1]);
  EXPECT_EQ(outputs[0], outputs[2]);
}

TEST(Query, TheTableHasARowForEachAnswerAndNoColourInAFile) {
  const ScratchFolder folder;
  const std::string single = folder / "single.json";
  write_text(single, head_on("1"));
  const Finished finished = ccdfuzz({"query", single, "--methods", "tdibm,tdibm-e"});
  EXPECT_EQ(finished.code, 0) << finished.err;
  EXPECT_EQ(finished.err, "");
  EXPECT_EQ(std::ranges::count(finished.out, '\n'), 9) << finished.out;
  EXPECT_EQ(finished.out.find('\x1b'), std::string::npos);
  EXPECT_NE(finished.out.find("correct"), std::string::npos) << finished.out;
}

}  // namespace
}  // namespace ccdfuzz
