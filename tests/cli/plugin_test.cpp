#include <gmock/gmock.h>

#include <filesystem>
#include <map>

#include "process.hpp"

namespace ccdfuzz {
namespace {

const std::string kMisbehaving = std::string("plugin:") + CCDFUZZ_TEST_MISBEHAVING_PLUGIN + ":";
const std::string kNaive = std::string("plugin:") + CCDFUZZ_TEST_NAIVE_PLUGIN;

/// The rows of a kind ("find", "cell", "summary").
std::vector<nlohmann::ordered_json> rows_of(const std::string& out, const std::string& kind) {
  std::vector<nlohmann::ordered_json> rows;
  for (auto& row : json_lines(out)) {
    if (row.at("row") == kind) rows.push_back(std::move(row));
  }
  return rows;
}

TEST(Plugins, AreOneFindPerMisbehaviourAndDoNotStopTheHunt) {
  const ScratchFolder folder;
  std::vector<std::string> methods;
  for (const char* does :
       {"crash", "exit", "throw", "hang:seconds=0.05", "memory:mb=64", "print", "silent", "nan",
        "outside", "verdict", "small", "overrun", "stale", "describe-abort"}) {
    // Only a hang reaches this limit, however busy the machine is.
    const bool hangs = std::string(does).starts_with("hang");
    methods.push_back(kMisbehaving + does + (hangs ? "" : ":seconds=30"));
  }
  std::vector<std::string> all = methods;
  all.emplace_back("tdibm");
  const Finished hunted = succeeded(
      ccdfuzz({"hunt", "--cases", "1", "--max-pops", "100", "--methods",
               fmt::format("{}", fmt::join(all, ",")), "--corpus", folder / "finds", "--json"}));
  std::map<std::string, int> finds;
  for (const auto& row : rows_of(hunted.out, "find")) {
    ++finds[row.at("method").get<std::string>()];
  }
  for (const std::string& method : methods) EXPECT_EQ(finds[method], 1) << method;
  for (const auto& cell : rows_of(hunted.out, "cell")) {
    if (cell.at("method") == "tdibm") {
      EXPECT_GT(cell.at("n"), 0) << cell;
    }
  }
  // Each is of the simplest query that there is, and shows itself again.
  for (const auto& row : rows_of(hunted.out, "find")) {
    if (row.at("method") == "tdibm") continue;
    const Finished again = shell(row.at("reproduce").get<std::string>() + " --json");
    for (const auto& answer : json_lines(again.out)) {
      EXPECT_EQ(answer.at("outcome"), "error") << answer;
      EXPECT_NE(answer.value("error", ""), "") << answer;
    }
  }
}

TEST(Plugins, AreRefutedAndTheFindsShrunkWhenTheyAreNaive) {
  const ScratchFolder folder;
  const Finished hunted = succeeded(ccdfuzz(
      {"hunt", "--cases", "1", "--methods", kNaive, "--corpus", folder / "finds", "--json"}));
  const auto finds = rows_of(hunted.out, "find");
  ASSERT_FALSE(finds.empty());
  for (const auto& find : finds) {
    // What a hunt draws has more than a thousand digits; nothing of it is needed.
    const auto entry = nlohmann::json::parse(read_text(find.at("path").get<std::string>()));
    EXPECT_LT(entry.at("patches").dump().size(), 900U) << entry;
  }
  succeeded(ccdfuzz({"verify", finds.front().at("path").get<std::string>()}));
  succeeded(ccdfuzz({"replay", folder / "finds", "--allow-plugins", kNaive}));
}

TEST(Plugins, AreCalledByTheNameThatTheCommandLineGivesThem) {
  const ScratchFolder folder;
  const std::string named = "naive=" + kNaive;
  const Finished hunted =
      succeeded(ccdfuzz({"hunt", "--cases", "1", "--plugin", named, "--methods", "plugin:naive",
                         "--corpus", folder / "finds", "--json"}));
  const auto finds = rows_of(hunted.out, "find");
  ASSERT_FALSE(finds.empty());
  for (const auto& find : finds) {
    EXPECT_EQ(find.at("method"), "plugin:naive");
    const std::string entry = read_text(find.at("path").get<std::string>());
    EXPECT_THAT(entry, testing::Not(testing::HasSubstr(CCDFUZZ_TEST_NAIVE_PLUGIN)));
  }
  const Finished unnamed = failed(ccdfuzz({"replay", folder / "finds"}));
  EXPECT_THAT(unnamed.err,
              testing::HasSubstr("--plugin NAME=SPEC what stands behind plugin:naive"));
  const Finished shown =
      succeeded(shell(finds.front().at("reproduce").get<std::string>() + " --json"));
  EXPECT_EQ(json_lines(shown.out).front().at("outcome"), finds.front().at("outcome"));
  const Finished replayed = succeeded(ccdfuzz({"replay", folder / "finds", "--plugin", named}));
  EXPECT_EQ(replayed.err, "");
  EXPECT_EQ(replayed.out,
            fmt::format("{0} entries, {0} expectations: all as expected\n", finds.size()));
}

TEST(Plugins, AreNotTracedAndHaveNoLostMutants) {
  const ScratchFolder folder;
  const auto table_of = [&](const std::string& methods) {
    return ccdfuzz({"hunt", "--cases", "1", "--corpus", folder / methods, "--max-pops", "50",
                    "--by-class", "--plugin", "naive=" + kNaive, "--methods", methods})
        .out;
  };
  const std::string alone = table_of("plugin:naive");
  EXPECT_THAT(alone, testing::HasSubstr("mutants"));
  EXPECT_THAT(alone, testing::Not(testing::HasSubstr("lost")));
  std::istringstream lines(table_of("tdibm,plugin:naive"));
  bool is_counted = false;
  for (std::string line; std::getline(lines, line) && !line.starts_with("lost:");) {
    if (line.starts_with("class")) is_counted = line.find("lost") != std::string::npos;
    if (!is_counted || line.find("  plugin:naive") == std::string::npos) continue;
    EXPECT_TRUE(line.ends_with(" -")) << line;
  }
  EXPECT_TRUE(is_counted);
}

TEST(Plugins, AreRefusedByTrace) {
  const std::string entry = CCDFUZZ_SOURCE_DIR "/corpus/cases/tdibm-e-underflow.json";
  const Finished done =
      refused(ccdfuzz({"trace", "--methods", "tdibm," + kNaive, entry}), "cannot be traced");
  EXPECT_EQ(done.out, "");
}

TEST(Plugins, AreStartedByThePrintedReplayCommand) {
  const ScratchFolder folder;
  for (const bool is_named : {false, true}) {
    const std::string finds = folder / (is_named ? "named" : "unnamed");
    std::vector<std::string> line = {
        "hunt", "--cases", "1", "--corpus", finds, "--methods", is_named ? "plugin:naive" : kNaive};
    if (is_named) line.insert(line.end(), {"--plugin", "naive=" + kNaive});
    const std::string out = ccdfuzz(line).out;
    const std::string before = "Run them all: ";
    const size_t at = out.find(before);
    ASSERT_NE(at, std::string::npos) << out;
    const size_t begin = at + before.size();
    const Finished replayed = succeeded(shell(out.substr(begin, out.find('\n', begin) - begin)));
    EXPECT_THAT(replayed.out, testing::HasSubstr(": all as expected"));
    EXPECT_THAT(replayed.out, testing::Not(testing::HasSubstr(" 0 expectations")));
  }
}

TEST(Plugins, AreRefusedWhenTheirNameIsNone) {
  for (const std::string& bad :
       {std::string("naive"), "a b=" + kNaive, "=" + kNaive, std::string("naive=tdibm"),
        "naive=" + kNaive + ",naive=" + kNaive, std::string("naive=plugin:/nowhere")}) {
    refused(ccdfuzz({"query", "nothing.json", "--plugin", bad, "--methods", "tdibm"}), "--plugin");
  }
  refused(ccdfuzz({"query", "nothing.json", "--methods", "plugin:naive"}), "\"plugin:naive\"");
}

TEST(Plugins, AreHuntedWithLinearQueriesWhenTheyTakeNoOthers) {
  const ScratchFolder folder;
  const std::string linear = std::string("plugin:") + CCDFUZZ_TEST_LINEAR_PLUGIN;
  const Finished hunted =
      succeeded(ccdfuzz({"hunt", "--linear", "--cases", "12", "--methods", linear + ",tdibm-c",
                         "--corpus", folder / "finds", "--json"}));
  std::map<std::string, int> asked;
  for (const auto& cell : rows_of(hunted.out, "cell")) {
    if (cell.at("method") != linear) {
      EXPECT_EQ(cell.at("missed").get<int>() + cell.at("late").get<int>(), 0) << cell;
    } else {
      asked[cell.at("class").get<std::string>()] = cell.at("n").get<int>();
      EXPECT_EQ(cell.at("undecided"), 0) << cell;
    }
  }
  EXPECT_GT(asked["VF"], 0);
  EXPECT_GT(asked["EE"], 0);
  EXPECT_FALSE(rows_of(hunted.out, "find").empty());
  succeeded(ccdfuzz({"replay", folder / "finds", "--allow-plugins", linear}));
}

/// Refuses every query.
const std::string kRefusing =
    std::string("plugin:") + CCDFUZZ_TEST_CLAIMING_PLUGIN + ":verdict=5:nan=1";

TEST(Plugins, AreNeverAskedWhenTheyRefuseEverything) {
  const ScratchFolder folder;
  const std::vector<std::string> hunt = {
      "hunt", "--cases", "1", "--methods", kRefusing, "--corpus", folder / "f", "--fail-on", "any"};
  const Finished told = failed(ccdfuzz(hunt));
  EXPECT_THAT(told.out, testing::HasSubstr("not asked: queries that a method refused; "));
  EXPECT_THAT(told.err, testing::HasSubstr("nothing was checked: no query was asked; every method "
                                           "refused what it was to be asked about 6 cases"));
  std::vector<std::string> as_json = hunt;
  as_json.emplace_back("--json");
  const Finished hunted = failed(ccdfuzz(as_json));
  for (const auto& cell : rows_of(hunted.out, "cell")) {
    EXPECT_EQ(cell.at("n"), 0) << cell;
    EXPECT_EQ(cell.at("positives"), 0) << cell;
    EXPECT_EQ(cell.at("cpu_seconds"), 0) << cell;
    EXPECT_GT(cell.at("not_asked"), 0) << cell;
  }
  EXPECT_EQ(rows_of(hunted.out, "summary").front().at("queries"), 0);
  EXPECT_TRUE(rows_of(hunted.out, "find").empty());
}

TEST(Plugins, HaveTheirRefusalsInAColumn) {
  const ScratchFolder folder;
  const std::string cases = folder / "c.jsonl";
  succeeded(ccdfuzz({"generate", "--contact", "VV", "--kind", "RP", "--count", "3", "-o", cases}));
  const std::string methods = kRefusing + ",tdibm-c";
  for (const auto& row :
       json_lines(ccdfuzz({"query", cases, "--methods", methods, "--json"}).out)) {
    const bool refused = row.at("method") == kRefusing;
    EXPECT_EQ(row.at("verdict") == "refused", refused) << row;
    EXPECT_EQ(row.at("outcome") == "not_asked", refused) << row;
  }
  const auto rows = json_lines(ccdfuzz({"evaluate", cases, "--methods", methods, "--json"}).out);
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[0].at("n"), 0);
  EXPECT_EQ(rows[0].at("not_asked"), 3);
  EXPECT_EQ(rows[1].at("n"), 3);
  EXPECT_EQ(rows[1].at("not_asked"), 0);
  const std::string table = ccdfuzz({"evaluate", cases, "--methods", methods}).out;
  EXPECT_THAT(table, testing::HasSubstr("not asked"));
  EXPECT_THAT(table, testing::HasSubstr("not asked: queries that a method refused; "));
  const std::string without = ccdfuzz({"evaluate", cases, "--methods", "tdibm-c"}).out;
  EXPECT_THAT(without, testing::Not(testing::HasSubstr("not asked")));
  const std::string bench = ccdfuzz({"bench", "--methods", "tdibm-c," + kRefusing, "--count", "1",
                                     "--classes", "VV", "--json"})
                                .out;
  const auto raced = json_lines(bench);
  ASSERT_EQ(raced.size(), 2U) << bench;
  EXPECT_EQ(raced[1].at("n"), 0);
  EXPECT_EQ(raced[1].at("not_asked"), 2);
  EXPECT_TRUE(raced[1].at("total_ratio").is_null());
  // An entry may expect it.
  auto entry = json_lines(read_text(cases)).front();
  entry["expect"] = {{"tdibm-c", "not_asked"}};
  write_text(folder / "entry.json", entry.dump());
  const Finished replayed = failed(ccdfuzz({"replay", folder / "entry.json", "--json"}));
  EXPECT_EQ(json_lines(replayed.out).front().at("expected"), "not_asked");
}

TEST(Plugins, WriteNothingAndHaveNoNetworkInBubblewrapAsThePageSays) {
  if (shell("bwrap --ro-bind / / --unshare-all true").code != 0) {
    GTEST_SKIP() << "bwrap is not installed, or not permitted here";
  }
  const std::string spy = std::string(CCDFUZZ_EXECUTABLE) + "-spy.sh";
  if (spy.starts_with("/tmp/")) GTEST_SKIP() << "the build stands in /tmp, which is hidden there";
  write_text(
      spy,
      "#!/bin/sh\n"
      "wrote=no; (: >\"$0.written\") 2>/dev/null && wrote=yes\n"
      "while read -r line; do case $line in *describe*)\n"
      "  echo \"{\\\"protocol\\\":1,\\\"name\\\":\\\"wrote $wrote, /tmp has $(ls /tmp | wc -l), \""
      "\"links $(grep -c : /proc/net/dev)\\\"}\" ;;\n"
      "esac; done\n");
  const ScratchFolder folder;
  const std::string page = read_text(std::string(CCDFUZZ_SOURCE_DIR) + "/SECURITY.md");
  const size_t line = page.find("#!/bin/sh\nexec bwrap "),
               end = page.find(" /home/me/mine.py", line);
  ASSERT_NE(end, std::string::npos);
  const auto confined = [&](const std::string& program) {
    write_text(folder / "confined.sh", page.substr(line, end - line) + " " + program + "\n");
    return shell(fmt::format("chmod +x '{0}/confined.sh' '{1}'; \"$ccdfuzz\" methods "
                             "plugin-exec:{0}/confined.sh",
                             folder.path(), program))
        .out;
  };
  EXPECT_THAT(confined(spy), testing::HasSubstr("wrote no, /tmp has 0, links 1"));
  EXPECT_THAT(shell("\"$ccdfuzz\" methods plugin-exec:" + spy).out,
              testing::HasSubstr("wrote yes"));
  std::filesystem::remove(spy);
  std::filesystem::remove(spy + ".written");
  EXPECT_THAT(confined(std::string(CCDFUZZ_SOURCE_DIR) + "/examples/plugins/boxes.py"),
              testing::HasSubstr("boxes, in Python"));
}

/// The C++ between the first pair of fences of the page for newcomers.
std::string newcomers_plugin() {
  const std::string page = read_text(CCDFUZZ_SOURCE_DIR "/docs/plug-ins.md");
  const std::string fence = "```cpp\n";
  const size_t begin = page.find(fence) + fence.size();
  return page.substr(begin, page.find("```", begin) - begin);
}

TEST(Plugins, TakeAtMostSixtyLinesToBuildAndHuntAsThePageSays) {
  const ScratchFolder folder;
  const std::string source = newcomers_plugin();
  EXPECT_LE(std::ranges::count(source, '\n'), 60);
  write_text(folder / "mine.cpp", source);
  succeeded(shell(fmt::format(
      "{} -std=c++17 -O2 -Wall -Wextra -Werror -shared -fPIC -I{}/src/method/plugin {} -o {}",
      CCDFUZZ_CXX, CCDFUZZ_SOURCE_DIR, folder / "mine.cpp", folder / "libmine.so")));
  const Finished hunted =
      succeeded(ccdfuzz({"hunt", "--cases", "2", "--methods", "plugin:" + (folder / "libmine.so"),
                         "--corpus", folder / "finds"}));
  EXPECT_THAT(hunted.err, testing::HasSubstr("ccdfuzz: hunt: found: "));
}

}  // namespace
}  // namespace ccdfuzz
