#include "io/run_file.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "scratch_folder.hpp"

namespace ccdfuzz {
namespace {

RunHeader header_of(std::uint64_t items = 4, Shard shard = {}, const char* seed = "7") {
  return {"test", "1.0", {"a.jsonl"}, {{"--seed", seed}}, items, shard};
}

std::string line_of(std::uint64_t item) {
  return fmt::format("{{\"index\":{},\"square\":{}}}", item, item * item);
}

std::vector<std::string> lines_of(const std::string& path) {
  Result<RunLines> lines = RunLines::open(path);
  std::vector<std::string> all;
  EXPECT_TRUE(lines) << lines.error().message();
  while (lines) {
    const auto line = lines->next();
    EXPECT_TRUE(line) << line.error().message();
    if (!line || !*line) break;
    all.emplace_back(**line);
  }
  return all;
}

class RunFileTest : public testing::Test {
 protected:
  RunFile open(const RunHeader& header = header_of()) {
    Result<RunFile> file = RunFile::open(path_, header);
    if (!file) throw std::runtime_error(file.error().message());
    return *std::move(file);
  }
  void fill(const std::vector<std::string>& lines) {
    RunFile file = open();
    for (const std::string& line : lines) ASSERT_TRUE(file.append(line));
  }
  std::string refusal(const RunHeader& header) {
    const Result<RunFile> other = RunFile::open(path_, header);
    return other ? "" : other.error().message();
  }

  ScratchFolder folder_;
  std::string path_ = folder_ / "x.partial";
  const std::vector<std::string> lines_ = {line_of(0), line_of(1), line_of(2), line_of(3)};
};

TEST_F(RunFileTest, GoesOnAfterNoLineThatIsNotThatOfItsItem) {
  for (const std::vector<std::string>& wrong :
       {std::vector{line_of(0), line_of(0)},
        {line_of(1)},
        {line_of(0), "garbage"},
        {""},
        {line_of(0), line_of(1), line_of(2), line_of(3), line_of(4)}}) {
    std::filesystem::remove(path_);
    fill(wrong);
    const std::string before = read_text(path_);
    EXPECT_NE(refusal(header_of()), "") << before;
    EXPECT_EQ(read_text(path_), before);
  }
}

// What a kill leaves is a beginning of the file, of any length.
TEST_F(RunFileTest, GoesOnAfterTheLastWholeLineWhereverItWasCutOff) {
  fill(lines_);
  const std::string whole = read_text(path_);
  size_t before = 0;
  for (size_t length = 0; length <= whole.size(); ++length) {
    write_text(path_, whole.substr(0, length));
    {
      RunFile file = open();
      const size_t left = file.size();
      EXPECT_GE(left, before);
      EXPECT_LE(left, lines_.size());
      before = left;
      EXPECT_EQ(lines_of(path_), std::vector(lines_.begin(), lines_.begin() + left));
      for (size_t i = left; i < lines_.size(); ++i) ASSERT_TRUE(file.append(lines_[i]));
      EXPECT_EQ(file.size(), lines_.size());
    }
    EXPECT_EQ(read_text(path_), whole) << "cut to " << length;
  }
  EXPECT_EQ(before, lines_.size());
}

TEST_F(RunFileTest, RefusesTheFileOfAnotherRunAndNamesWhatDiffers) {
  fill(lines_);
  const std::string before = read_text(path_);
  const std::string seed = refusal(header_of(4, {}, "8"));
  EXPECT_NE(seed.find(path_), std::string::npos) << seed;
  EXPECT_NE(seed.find("--seed 7 in place of 8"), std::string::npos) << seed;
  EXPECT_NE(refusal(header_of(4, {0, 2})).find("--shard 0/1 in place of 0/2"), std::string::npos);
  EXPECT_NE(refusal(header_of(5)).find("items 4 in place of 5"), std::string::npos);
  RunHeader less = header_of();
  less.asked.clear();
  EXPECT_NE(refusal(less).find("--seed 7, which was not given here"), std::string::npos)
      << refusal(less);
  EXPECT_EQ(read_text(path_), before);
  for (const char* foreign : {"{}\n", "notes", "{\"format\":\"x\"}"}) {
    write_text(path_, foreign);
    EXPECT_NE(refusal(header_of()).find("in the way"), std::string::npos) << foreign;
    EXPECT_EQ(read_text(path_), foreign);
  }
}

TEST_F(RunFileTest, OneProcessAtATime) {
  const RunFile first = open();
  EXPECT_NE(refusal(header_of()).find("another process"), std::string::npos);
}

TEST_F(RunFileTest, IsReadWhileItsRunGoesOnAndStaysAsItIs) {
  fill(lines_);
  const RunFile running = open();
  const std::uintmax_t size = std::filesystem::file_size(path_) - 1;
  std::filesystem::resize_file(path_, size);
  EXPECT_EQ(lines_of(path_), std::vector(lines_.begin(), lines_.begin() + 3));
  EXPECT_EQ(std::filesystem::file_size(path_), size);
  EXPECT_FALSE(RunLines::open(folder_ / "nosuch"));
}

TEST_F(RunFileTest, AtItsEndItIsRemovedOrTakesTheNameOfTheOutput) {
  fill(lines_);
  ASSERT_TRUE(open().rename(folder_ / "x"));
  EXPECT_FALSE(std::filesystem::exists(path_));
  EXPECT_EQ(lines_of(folder_ / "x"), lines_);
  ASSERT_TRUE(open().remove());
  EXPECT_FALSE(std::filesystem::exists(path_));
}

/// The paths of `of` shares of a run of 7 items, whose lines are those of line_of.
std::vector<std::string> shares(const ScratchFolder& folder, std::uint64_t of,
                                const char* seed = "7") {
  std::vector<std::string> paths;
  for (std::uint64_t i = 0; i < of; ++i) {
    paths.push_back(folder / ("share-" + std::to_string(i) + seed));
    auto file = RunFile::open(paths.back(), header_of(7, {i, of}, seed));
    EXPECT_TRUE(file);
    for (std::uint64_t k = i; k < 7; k += of) EXPECT_TRUE(file->append(line_of(k)));
  }
  return paths;
}

std::string merged_refusal(const std::vector<std::string>& paths) {
  Result<MergedRun> run = MergedRun::open(paths);
  if (!run) return run.error().message();
  for (;;) {
    const auto line = run->next();
    if (!line) return line.error().message();
    if (!*line) return "";
  }
}

TEST(MergedRun, GivesTheItemsAsOneRunHasThem) {
  for (const std::uint64_t of : {1, 2, 3, 7, 9}) {
    const ScratchFolder folder;
    std::vector<std::string> paths = shares(folder, of);
    std::ranges::reverse(paths);
    Result<MergedRun> run = MergedRun::open(paths);
    ASSERT_TRUE(run) << run.error().message();
    EXPECT_FALSE(header_of(7).difference(run->header()));
    EXPECT_EQ(run->header().shard, Shard());
    for (int k = 0; k < 7; ++k) EXPECT_EQ(run->next().value(), line_of(k));
    EXPECT_FALSE(run->next().value());
  }
}

TEST(MergedRun, RefusesFilesThatAreNotTheSharesOfOneRun) {
  const ScratchFolder folder;
  const std::vector<std::string> paths = shares(folder, 3), others = shares(folder, 3, "8");
  EXPECT_EQ(merged_refusal(paths), "");
  EXPECT_NE(merged_refusal({paths[0], paths[2]}).find("share 1/3 is missing"), std::string::npos);
  EXPECT_NE(merged_refusal({paths[0], paths[0]}).find("share 0/3 is there twice"),
            std::string::npos);
  EXPECT_NE(merged_refusal({paths[0], others[1], paths[2]}).find("--seed 8 in place of 7"),
            std::string::npos);
  std::filesystem::resize_file(paths[1], std::filesystem::file_size(paths[1]) - 1);
  EXPECT_NE(merged_refusal(paths).find("is not complete"), std::string::npos);
  const std::string whole =
      read_text(others[1]).replace(read_text(others[1]).find("\"8\""), 3, "\"7\"");
  write_text(paths[1], whole);
  EXPECT_EQ(merged_refusal(paths), "");
  write_text(paths[1], whole + line_of(7) + "\n");
  EXPECT_NE(merged_refusal(paths).find("has more than its items"), std::string::npos);
}

}  // namespace
}  // namespace ccdfuzz
