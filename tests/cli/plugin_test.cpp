#include <gtest/gtest.h>

#include <map>

#include "process.hpp"

namespace ccdfuzz {
namespace {

const std::string kMisbehaving = std::string("plugin:") + CCDFUZZ_TEST_MISBEHAVING_PLUGIN + ":";
const std::string kNaive = std::string("plugin:") + CCDFUZZ_TEST_NAIVE_PLUGIN;

std::string joined(const std::vector<std::string>& words) {
  return fmt::format("{}", fmt::join(words, ","));
}

/// The rows of a kind ("find", "cell", "summary").
std::vector<nlohmann::ordered_json> rows_of(const std::string& out, const std::string& kind) {
  std::vector<nlohmann::ordered_json> rows;
  for (auto& row : json_lines(out)) {
    if (row.at("row") == kind) rows.push_back(std::move(row));
  }
  return rows;
}

TEST(Plugins, ThatMisbehaveLeaveTheHuntRunningAndAreOneFindEach) {
  const ScratchFolder folder;
  std::vector<std::string> methods;
  for (const char* does :
       {"crash", "exit", "throw", "hang:seconds=0.1", "memory:mb=100", "print", "silent", "nan",
        "outside", "verdict", "small", "overrun", "stale", "describe-abort"}) {
    methods.push_back(kMisbehaving + does);
  }
  std::vector<std::string> all = methods;
  all.emplace_back("tdibm");
  const Finished hunted = ccdfuzz({"hunt", "--cases", "1", "--max-pops", "100", "--methods",
                                   joined(all), "--corpus", folder / "finds", "--json"});
  ASSERT_EQ(hunted.code, 0) << hunted.err;
  std::map<std::string, int> finds;
  for (const auto& row : rows_of(hunted.out, "find")) {
    for (const auto& method : row.at("failures")) ++finds[method.get<std::string>()];
  }
  for (const std::string& method : methods) EXPECT_EQ(finds[method], 1) << method;
  for (const auto& cell : rows_of(hunted.out, "cell")) {
    if (cell.at("method") == "tdibm") {
      EXPECT_GT(cell.at("n"), 0) << cell;
    }
  }
  // Each is of the simplest query that there is, and shows itself again.
  for (const auto& row : rows_of(hunted.out, "find")) {
    if (row.at("failures").front() == "tdibm" || row.at("failures").back() == "tdibm") continue;
    const Finished again = shell(row.at("reproduce").get<std::string>() + " --json");
    for (const auto& answer : json_lines(again.out)) {
      EXPECT_EQ(answer.at("outcome"), "error") << answer;
      EXPECT_NE(answer.value("error", ""), "") << answer;
    }
  }
}

TEST(Plugins, ThatAreNaiveAreBrokenAndTheFindsShrunk) {
  const ScratchFolder folder;
  const Finished hunted = ccdfuzz(
      {"hunt", "--cases", "1", "--methods", kNaive, "--corpus", folder / "finds", "--json"});
  ASSERT_EQ(hunted.code, 0) << hunted.err;
  const auto finds = rows_of(hunted.out, "find");
  ASSERT_FALSE(finds.empty());
  for (const auto& find : finds) {
    // What a hunt draws has more than a thousand digits; nothing of it is needed.
    const auto entry = nlohmann::json::parse(read_text(find.at("path").get<std::string>()));
    EXPECT_LT(entry.at("patches").dump().size(), 900U) << entry;
  }
  EXPECT_EQ(ccdfuzz({"verify", finds.front().at("path").get<std::string>()}).code, 0);
  const Finished replayed = ccdfuzz({"replay", folder / "finds"});
  EXPECT_EQ(replayed.code, 0) << replayed.out << replayed.err;
}

TEST(Plugins, CountAsClaimsWhereTheyClaim) {
  const ScratchFolder folder;
  // It claims to be conservative, and says "hit" at t_max for ever.
  const std::string late = kMisbehaving + "late";
  EXPECT_EQ(ccdfuzz({"hunt", "--cases", "1", "--methods", late, "--corpus", folder / "finds",
                     "--fail-on", "claims"})
                .code,
            1);
  EXPECT_EQ(ccdfuzz({"hunt", "--cases", "1", "--methods", kNaive, "--corpus", folder / "naive",
                     "--fail-on", "claims"})
                .code,
            0);
}

/// The C++ between the first pair of fences of the page for newcomers.
std::string newcomers_plugin() {
  const std::string page = read_text(CCDFUZZ_SOURCE_DIR "/examples/plugins/README.md");
  const std::string fence = "```cpp\n";
  const size_t begin = page.find(fence) + fence.size();
  return page.substr(begin, page.find("```", begin) - begin);
}

TEST(Plugins, OfANewcomerIsAtMostSixtyLinesBuiltAndHuntedAsThePageSays) {
  const ScratchFolder folder;
  const std::string source = newcomers_plugin();
  EXPECT_LE(std::ranges::count(source, '\n'), 60);
  write_text(folder / "mine.cpp", source);
  const Finished built = shell(fmt::format(
      "{} -std=c++17 -O2 -Wall -Wextra -Werror -shared -fPIC -I{}/src/method/plugin {} -o {}",
      CCDFUZZ_CXX, CCDFUZZ_SOURCE_DIR, folder / "mine.cpp", folder / "libmine.so"));
  ASSERT_EQ(built.code, 0) << built.err;
  const Finished hunted =
      ccdfuzz({"hunt", "--cases", "2", "--methods", "plugin:" + (folder / "libmine.so"), "--corpus",
               folder / "finds"});
  EXPECT_EQ(hunted.code, 0) << hunted.err;
  EXPECT_NE(hunted.out.find("by plugin:"), std::string::npos) << hunted.out;
}

TEST(Minimize, WritesAnEntryThatFailsAlikeAndRefusesWhatDoesNotFail) {
  const ScratchFolder folder;
  const std::string underflow = CCDFUZZ_SOURCE_DIR "/corpus/regressions/tdibm-e-underflow.json";
  const std::string small = folder / "small.json";
  const Finished shrunk =
      ccdfuzz({"minimize", underflow, "--method", "tdibm-e", "-o", small, "--json"});
  ASSERT_EQ(shrunk.code, 0) << shrunk.err;
  const auto row = json_lines(shrunk.out).front();
  EXPECT_LE(row.at("bits"), row.at("bits_before"));
  EXPECT_EQ(ccdfuzz({"verify", small}).code, 0);
  EXPECT_EQ(ccdfuzz({"replay", small}).code, 0);
  const Finished refused = ccdfuzz({"minimize", small, "--method", "tdibm-c"});
  EXPECT_EQ(refused.code, 2);
  EXPECT_NE(refused.err.find("no failure to shrink"), std::string::npos) << refused.err;
}

}  // namespace
}  // namespace ccdfuzz
