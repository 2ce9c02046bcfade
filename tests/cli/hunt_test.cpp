#include <gtest/gtest.h>

#include <filesystem>
#include <map>

#include "files/case_files.hpp"
#include "process.hpp"
#include "share.hpp"

namespace ccdfuzz {
namespace {

namespace fs = std::filesystem;

/// Plain TDIBM fails on the first draws; few pops keep the flat classes short.
const std::vector<std::string> kQuick = {"--methods", "tdibm,tdibm-h:1e-16", "--max-pops", "20"};
constexpr int kCases = kOneIn == 1 ? 6 : 3;  // a class; shared by three
const std::string kAFew = std::to_string(kCases);

std::vector<std::string> hunt(const std::string& corpus, std::vector<std::string> more) {
  return with(with({"hunt", "--corpus", corpus}, kQuick), more);
}

/// File name → contents, of everything in a folder.
std::map<std::string, std::string> files_in(const std::string& folder) {
  std::map<std::string, std::string> files;
  if (!fs::exists(folder)) return files;
  for (const auto& entry : fs::directory_iterator(folder)) {
    files[entry.path().filename()] = read_text(entry.path());
  }
  return files;
}

TEST(Hunt, RepeatsExactlyByCasesOnAnyNumberOfThreads) {
  std::vector<std::string> tables;
  std::vector<nlohmann::json> pages;
  std::vector<std::map<std::string, std::string>> finds;
  for (const char* threads : {"1", "2"}) {
    const ScratchFolder folder;
    const Finished finished =
        succeeded(ccdfuzz(hunt(folder / "finds", {"--cases", kAFew, "--threads", threads, "--json",
                                                  "--report", folder / "page"})));
    std::string& table = tables.emplace_back();
    for (auto& row : json_lines(finished.out)) {
      for (const char* varies :
           {"cpu_seconds", "mean_seconds", "p999_seconds", "seconds", "path", "reproduce"}) {
        row.erase(varies);
      }
      table += row.dump() + "\n";
    }
    finds.push_back(files_in(folder / "finds"));
    nlohmann::json page = page_data(folder / "page");
    for (const char* varies : {"title", "command", "cases", "tables"}) page.erase(varies);
    for (auto& sample : page["course"]["samples"]) sample.erase(0);  // the time
    pages.push_back(page);
  }
  EXPECT_EQ(tables[0], tables[1]);
  EXPECT_EQ(pages[0], pages[1]) << "with the course of the hunt";
  EXPECT_EQ(finds[0], finds[1]);
  EXPECT_FALSE(finds[0].empty());
}

TEST(Hunt, CtrlCOrAClosedTerminalPrintsTheTableAndKeepsTheFinds) {
  for (const int signal : {SIGINT, SIGHUP}) {
    const ScratchFolder folder;
    const std::string finds = folder / "finds";
    Process process(hunt(finds, {"--seconds", "600"}));
    process.wait_until([&] { return !entries_in(finds).empty(); });
    const Finished finished = process.ended_by(signal);
    EXPECT_THAT(finished.out, testing::ContainsRegex("\nmethod (.|\n)*new counterexamples"));
    succeeded(ccdfuzz({"replay", finds}));
  }
}

TEST(Hunt, MinimisesWithinTheNumbersThatItWasAskedFor) {
  const ScratchFolder folder;
  const Finished finished =
      ccdfuzz({"hunt", "--corpus", folder / "finds", "--cases", "60", "--within", "7", "--plugin",
               "fcl=plugin:" CCDFUZZ_TEST_LINEAR_PLUGIN, "--methods", "plugin:fcl", "--json"});
  int numbers = 0, tests = 0;
  for (const auto& row : json_lines(finished.out)) {
    if (row.at("row") != "find") continue;
    const std::string path = row.at("path");
    const Case find = read_case(path).value().value;
    EXPECT_EQ(find.origin.more.at("version"), "\"1.0\"") << "of the plug-in, as it says";
    if (row.contains("export") && row.contains("depth")) {
      succeeded(ccdfuzz({"export", path, "--as", "fcl", "-o", folder / "test.cpp"}));
      EXPECT_THAT(read_text(folder / "test.cpp"), testing::HasSubstr(" deep.\n"));
      ++tests;
    }
    for_each_number(find.query, [&](double x) {
      ++numbers;
      EXPECT_TRUE(x == 0 || (0x1p-7 <= std::abs(x) && std::abs(x) <= 0x1p7)) << to_hex(x);
    });
  }
  EXPECT_TRUE(numbers > 100 && tests > 0) << numbers << ", " << tests;
}

}  // namespace
}  // namespace ccdfuzz
