#include <gmock/gmock.h>

#include <filesystem>
#include <map>

#include "falling_vertex.hpp"
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
  for (const char* does : {"crash", "exit", "throw", "hang:seconds=0.05", "memory:mb=64", "print",
                           "silent", "nan", "outside", "verdict", "small", "overrun", "stale"}) {
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

/// The spec of a plug-in that answers for a while, several times a query, and is then there no
/// more.
std::string vanishing(const std::string& path) {
  write_text(path, R"(#!/bin/sh
read line || exit
echo '{"protocol":1}'
for _ in $(seq 20); do
  read line || exit
  id=$(echo "$line" | sed 's/.*"id":\([0-9]*\).*/\1/')
  echo "{\"id\":$id,\"verdict\":\"miss\"}"
done
rm "$0"
)");
  std::filesystem::permissions(path, std::filesystem::perms::owner_all);
  return "plugin-exec:" + path;
}

TEST(Plugins, ThatVanishEndCommandsWithWhatTheyHave) {
  const ScratchFolder folder;
  const std::string csv = folder / "vertex-face.csv", program = folder / "vanishing";
  std::string queries;
  for (int i = 0; i < 9; ++i) queries += falling_vertex("-1,2", 1);
  write_text(csv, queries);
  const auto run = [&](std::vector<std::string> command) {
    Finished finished =
        ccdfuzz(with(std::move(command), {csv, "--threads", "1", "--methods", vanishing(program)}));
    EXPECT_EQ(finished.code, 3) << finished.out << finished.err;
    EXPECT_THAT(finished.err, testing::HasSubstr("no process answers"));
    EXPECT_THAT(finished.err, testing::HasSubstr("ccdfuzz: \"plugin-exec:" + program));
    return finished;
  };
  const auto some_cases = testing::ContainsRegex("[2-8] cases, [2-8] queries a method");
  EXPECT_THAT(run({"evaluate"}).out, some_cases);
  EXPECT_THAT(run({"evaluate", "--csv", folder / "out.csv"}).out, some_cases);
  const std::string answers = folder / "run/answers.jsonl";
  EXPECT_THAT(run({"evaluate", "-o", folder / "run"}).err,
              testing::HasSubstr("goes on from there"));
  EXPECT_THAT(run({"replay", "--expect", "correct"}).out,
              testing::ContainsRegex("[2-8] entries, [2-8] expect"));
  EXPECT_THAT(run({"query"}).out, testing::ContainsRegex("[2-8] cases, [2-8] answers"));
  EXPECT_FALSE(std::filesystem::exists(answers) || std::filesystem::exists(folder / "out.csv"));
  EXPECT_TRUE(std::filesystem::exists(answers + ".partial"));
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
