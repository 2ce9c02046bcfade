// Nothing that a file names is started: every command that reads cases is given a plug-in to fall
// for.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "process.hpp"

namespace ccdfuzz {
namespace {

using testing::HasSubstr;

constexpr const char* kHonestEntry = CCDFUZZ_SOURCE_DIR "/corpus/cases/tdibm-e-underflow.json";

/// A corpus of one entry, whose expectations name a plug-in program; it leaves a mark when it runs.
class Trap {
 public:
  Trap() {
    write_text(folder_ / "trap", "#!/bin/sh\ntouch '" + (folder_ / "sprung") + "'\n");
    std::filesystem::permissions(folder_ / "trap", std::filesystem::perms::owner_all);
    auto entry = nlohmann::ordered_json::parse(read_text(kHonestEntry));
    entry["expect"] = {{"tdibm-c", "correct"}, {spec(), "error"}, {"plugin:" + program(), "late"}};
    entry["origin"]["plugin"] = spec();
    std::filesystem::create_directories(corpus());
    write_text(entry_path(), entry.dump());
    write_text(folder_ / "cases.jsonl", entry.dump() + "\n");
  }

  std::string program() const { return folder_ / "trap"; }
  std::string spec() const { return "plugin-exec:" + program(); }
  std::string corpus() const { return folder_ / "corpus"; }
  std::string entry_path() const { return folder_ / "corpus/entry.json"; }
  std::string operator/(const std::string& name) const { return folder_ / name; }
  bool is_sprung() const { return std::filesystem::exists(folder_ / "sprung"); }

 private:
  ScratchFolder folder_;
};

/// The command ended as it should, without a fault of its own, and started nothing.
void expect_data(const Trap& trap, const std::vector<std::string>& command, int code = 0) {
  const Finished done = ccdfuzz(command);
  EXPECT_EQ(done.code, code) << testing::PrintToString(command) << done.out << done.err;
  EXPECT_FALSE(trap.is_sprung()) << testing::PrintToString(command);
}

TEST(FilesAreData, CommandsThatReadCasesStartNothing) {
  const Trap trap;
  const std::string cases = trap / "cases.jsonl", entry = trap.entry_path();
  expect_data(trap, {"query", cases, "--methods", "tdibm-c"});
  expect_data(trap, {"verify", cases});
  expect_data(trap, {"prove", cases, "-o", trap / "proven.jsonl"});
  expect_data(trap, {"export", cases, "--as", "gtest", "-o", trap / "found_test.cpp"});
  expect_data(trap, {"merge", cases, "-o", trap / "merged.jsonl"}, 2);
  expect_data(trap, {"trace", cases, "--methods", "tdibm-c"});
  expect_data(trap, {"minimize", entry, "--method", "tdibm-e", "-o", trap / "small.json"});
  expect_data(trap, {"triage", entry, "--methods", "tdibm-e", "--known", trap.corpus(), "-o",
                     trap / "finds"});
  expect_data(trap, {"merge", trap.corpus(), trap.corpus(), "-o", trap / "both"});
  expect_data(trap, {"evaluate", cases, "--methods", "tdibm-c", "-o", trap / "run"});
}

TEST(FilesAreData, ReplayLeavesOutWhatIsNotAllowedAndSaysSo) {
  const Trap trap;
  const Finished done = succeeded(ccdfuzz({"replay", trap.corpus()}));
  EXPECT_FALSE(trap.is_sprung());
  EXPECT_EQ(done.out, "1 entry, 1 expectation: all as expected\n");
  EXPECT_THAT(done.err,
              HasSubstr("2 expectations of plug-ins not run: allow them with --allow-plugins "));
  EXPECT_THAT(done.err, HasSubstr(trap.spec()));
  const auto rows = json_lines(ccdfuzz({"replay", trap.corpus(), "--json"}).out);
  EXPECT_EQ(std::ranges::count(rows, "not_asked",
                               [](const auto& row) { return row.value("outcome", ""); }),
            2);
  EXPECT_FALSE(trap.is_sprung());
  // One of the two: it dies without a word, as the entry says.
  const Finished allowed = ccdfuzz({"replay", trap.corpus(), "--allow-plugins", trap.spec()});
  EXPECT_TRUE(trap.is_sprung()) << "the trap works once it is allowed";
  EXPECT_EQ(allowed.code, 0) << allowed.err;
  EXPECT_EQ(allowed.out, "1 entry, 2 expectations: all as expected\n");
  EXPECT_THAT(allowed.err, HasSubstr("1 expectation of plug-ins not run"));
}

TEST(FilesAreData, OnlyPluginsCanBeAllowed) {
  const Trap trap;
  for (const std::string list : {"", "tdibm-c", "plugin:/nowhere", "plugin:"}) {
    const Finished done =
        refused(ccdfuzz({"replay", trap.corpus(), "--allow-plugins", list}), "--allow-plugins");
    EXPECT_THAT(done.err, HasSubstr(list.empty() ? "is empty" : "\"" + list + "\"")) << list;
  }
}

TEST(FilesAreData, ReportShowsWhatIsNotAllowedAsTheFileHasIt) {
  const Trap trap;
  const Finished done = succeeded(ccdfuzz({"report", trap.corpus(), "-o", trap / "page"}));
  EXPECT_FALSE(trap.is_sprung());
  EXPECT_THAT(done.err, HasSubstr("2 expectations of plug-ins not run"));
  EXPECT_THAT(page_data(trap / "page")["methods"].dump(), HasSubstr(trap.spec()));
}

// The method's name in the records of runs is text like any.
TEST(FilesAreData, RecordsOfRunsStartNothing) {
  const Trap trap;
  const auto replace_all = [](const std::string& path, const std::string& from,
                              const std::string& to) {
    std::string text = read_text(path);
    for (size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size()) {
      text.replace(at, from.size(), to);
    }
    write_text(path, text);
  };
  const std::string run = trap / "run";
  expect_data(trap, {"evaluate", trap / "cases.jsonl", "--methods", "tdibm-c", "-o", run});
  for (const auto& file : std::filesystem::directory_iterator(run)) {
    replace_all(file.path(), "tdibm-c", trap.spec());
  }
  expect_data(trap, {"report", run, "-o", trap / "page"});
  expect_data(trap, {"merge", run, "-o", trap / "merged"});
  expect_data(trap, {"evaluate", trap / "cases.jsonl", "--methods", "tdibm-c", "-o", run});
}

// The second hunt adds its failures to the entries of the first and shrinks them.
TEST(FilesAreData, AHuntIntoAStoreStartsNothingOfWhatItHolds) {
  const Trap trap;
  const std::string finds = trap / "finds";
  const auto hunted = [&](const std::string& method) {
    return std::vector<std::string>{"hunt",     "--cases", "2",        "--methods", method,
                                    "--shrink", "none",    "--corpus", finds};
  };
  expect_data(trap, hunted("tdibm"));
  std::size_t entries = 0;
  for (const auto& file : std::filesystem::recursive_directory_iterator(finds)) {
    if (file.path().extension() != ".json") continue;
    auto entry = nlohmann::ordered_json::parse(read_text(file.path()));
    entry["expect"][trap.spec()] = "missed";
    write_text(file.path(), entry.dump());
    ++entries;
  }
  ASSERT_GT(entries, 0U);
  std::vector<std::string> again = hunted("tdibm-h:1e-16");
  again[6] = "all";
  expect_data(trap, again);
}

}  // namespace
}  // namespace ccdfuzz
