#include <gtest/gtest.h>

#include <set>

#include "io/run_file.hpp"
#include "process.hpp"

namespace ccdfuzz {
namespace {

namespace fs = std::filesystem;

/// A small part of the set: every class and kind, FF most.
constexpr const char* kOneInSome = "1500";

std::vector<std::string> paper(const std::string& output, std::vector<std::string> more = {}) {
  return with({"generate", "--paper", "--one-in", kOneInSome, "-o", output}, more);
}

/// The files of a data set, without the times of its costs.
std::vector<std::string> contents(const ScratchFolder& folder, const std::string& name) {
  std::vector<std::string> all = {read_text(folder / (name + ".jsonl.zst")),
                                  read_text(folder / (name + ".trees.zst"))};
  for (nlohmann::ordered_json row : json_lines(read_text(folder / (name + ".generation.jsonl")))) {
    row.erase("cpu_seconds");
    all.push_back(row.dump());
  }
  return all;
}

class PaperSet : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder = new ScratchFolder;
    made = ccdfuzz(paper(*folder / "whole.jsonl.zst"));
  }
  static void TearDownTestSuite() { delete folder; }

  void TearDown() override {
    for (const auto& entry : fs::directory_iterator(folder->path())) {
      if (!entry.path().filename().string().starts_with("whole.")) fs::remove_all(entry.path());
    }
  }

  static inline ScratchFolder* folder = nullptr;
  static inline Finished made;
};

TEST_F(PaperSet, IsWhatVerifyAccepts) {
  ASSERT_EQ(made.code, 0) << made.err;
  EXPECT_EQ(folder->entry_count(), 3U) << "cases, trees and what they cost";
  const Finished verified = succeeded(ccdfuzz({"verify", *folder / "whole.jsonl.zst", "--json"}));
  // FF: 5 twice and 1 of each grazing kind; all other classes: 1 of each kind.
  EXPECT_EQ(json_lines(verified.out).size(), 12U + 5 * 4);
}

TEST_F(PaperSet, HasARowForEachClassAndKindAndNoQueryTwice) {
  const auto rows = json_lines(ccdfuzz(paper(*folder / "json.jsonl", {"--json"})).out);
  EXPECT_EQ(rows.size(), 18U);
  EXPECT_EQ(rows[0].at("contact"), "FF");
  EXPECT_EQ(rows[0].at("cases"), 10);
  std::set<std::string> queries;
  const auto cases = json_lines(read_text(*folder / "json.jsonl"));
  for (const auto& one : cases) queries.insert(one.at("patches").dump() + one.at("t_max").dump());
  EXPECT_EQ(queries.size(), cases.size()) << "a query is there twice";
}

TEST_F(PaperSet, CtrlCSaysHowToGoOn) {
  const std::string path = *folder / "stopped.jsonl.zst";
  const Finished finished =
      ended_by(SIGINT, {"generate", "--paper", "-o", path}, RunFile::path_for(path), 5000);
  EXPECT_EQ(finished.code, 128 + SIGINT);
  EXPECT_THAT(finished.err, testing::HasSubstr("the same command goes on"));
  EXPECT_FALSE(fs::exists(path));
}

// Interrupted, then run again with nowhere to say that it resumes.
TEST_F(PaperSet, IsNotWrittenOnInPlaceOfAClosedStream) {
  const std::string set = *folder / "p.jsonl";
  const std::string line =
      fmt::format("timeout -s INT 1 \"$ccdfuzz\" generate --paper --one-in 400 -o {}", set);
  shell(line + " --threads 1");
  shell(line + " --threads 1 2>&-");
  EXPECT_EQ(shell("grep -c 'going on behind' " + set + ".partial").code,
            fs::exists(set + ".partial") ? 1 : 2);
}

TEST_F(PaperSet, APartialFileOfAnotherRunIsAnErrorThatNamesIt) {
  const std::string path = *folder / "stopped.jsonl.zst";
  const std::vector<std::string> command = {"generate", "--paper", "-o", path};
  ended_by(SIGKILL, with(command, {"--seed", "1"}), RunFile::path_for(path), 5000);
  const std::string before = read_text(path + ".partial");
  for (const std::vector<std::string>& other : std::vector<std::vector<std::string>>{
           {"--seed", "2"}, {"--seed", "1", "--shard", "0/2"}, {"--seed", "1", "--one-in", "2"}}) {
    const std::string told = refused(ccdfuzz(with(command, other)), path + ".partial").err;
    EXPECT_THAT(told, testing::HasSubstr(other[other.size() - 2]));
  }
  EXPECT_EQ(read_text(path + ".partial"), before);
}

TEST_F(PaperSet, SharesMergeIntoTheWholeWhateverTheirOrder) {
  for (const int of : {2, 5}) {
    std::vector<std::string> merge = {"merge", "-o", *folder / "merged.jsonl.zst"};
    for (int i = of - 1; i >= 0; --i) {
      merge.push_back(*folder / fmt::format("share-{}.jsonl.zst", i));
      succeeded(ccdfuzz(paper(merge.back(), {"--shard", fmt::format("{}/{}", i, of)})));
    }
    succeeded(ccdfuzz(merge));
    EXPECT_EQ(contents(*folder, "merged"), contents(*folder, "whole")) << of;
  }
}

TEST(PlainSet, CtrlCLeavesNoFileBehind) {
  const ScratchFolder folder;
  Process process({"generate", "--contact", "VV", "--kind", "RP", "--count", "1000000000", "-o",
                   folder / "set.jsonl"});
  while (fs::is_empty(folder.path())) std::this_thread::yield();
  process.signal(SIGINT);
  const Finished finished = process.wait();
  EXPECT_EQ(finished.code, 128 + SIGINT);
  EXPECT_THAT(finished.err, testing::HasSubstr("set.jsonl was not written"));
  EXPECT_TRUE(fs::is_empty(folder.path()));
}

}  // namespace
}  // namespace ccdfuzz
