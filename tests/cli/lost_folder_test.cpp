// The folder of a hunt's finds is removed or cannot be written while it runs.
#include <gmock/gmock.h>

#include <filesystem>
#include <optional>
#include <thread>

#include "process.hpp"

namespace ccdfuzz {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

size_t count_of(const std::string& text, const std::string& part) {
  size_t count = 0;
  for (size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

/// A long hunt that has stored something. Plain TDIBM fails on the first draws.
class LostFolder : public testing::Test {
 protected:
  void begin(const char* seconds) {
    fs::create_directory(away_);
    fs::create_directory_symlink(away_, finds_);
    hunt_.emplace(std::vector<std::string>{"hunt", "--corpus", finds_, "--seconds", seconds,
                                           "--methods", "tdibm", "--max-pops", "20"});
    wait_for_entries();
  }

  void wait_for_entries(size_t count = 1) {
    hunt_->wait_until([&] { return entries_in(finds_).size() >= count; });
  }

  /// In one step: the hunt would make a folder again that is away for a moment.
  void put_file_in_place() {
    write_text(folder_ / "file", "no folder");
    fs::rename(folder_ / "file", finds_);
  }

  /// Ends the hunt. Its folder has all that was found before the loss.
  Finished end() {
    Finished finished = hunt_->ended_by(SIGINT);
    // An entry may have been replaced by a smaller one since.
    succeeded(ccdfuzz({"merge", finds_, away_, "-o", folder_ / "merged"}));
    EXPECT_EQ(entries_in(folder_ / "merged"), entries_in(finds_));
    return finished;
  }

  /// The hunt's folder is a link. What it has stored stays in `away_` when the link is gone.
  ScratchFolder folder_;
  const std::string finds_ = folder_ / "finds", away_ = folder_ / "away";
  std::optional<Process> hunt_;
};

TEST_F(LostFolder, IsMadeAgainWithAllFinds) {
  begin("600");
  fs::remove(finds_);
  wait_for_entries(entries_in(away_).size());
  const Finished finished = end();
  EXPECT_EQ(count_of(finished.err, "the hunt continues"), 1U) << finished.err;
  EXPECT_THAT(finished.err, HasSubstr(finds_)) << finished.err;
  // Finds that fail alike, but for their class, are in one line.
  EXPECT_GT(count_of(finished.out, "\n  tdibm-"), 0U) << finished.out;
  EXPECT_LE(count_of(finished.out, "\n  tdibm-"), entries_in(finds_).size()) << finished.out;
  succeeded(ccdfuzz({"replay", finds_}));
}

TEST_F(LostFolder, IsWrittenOnceItCanBe) {
  begin("600");
  put_file_in_place();
  std::this_thread::sleep_for(std::chrono::milliseconds(300));
  EXPECT_FALSE(hunt_->is_over());
  fs::remove(finds_);
  wait_for_entries(entries_in(away_).size());
  end();
}

TEST_F(LostFolder, IsAnErrorAfterTheSummaryAndTheCasesWhenItStaysLost) {
  begin("5");
  put_file_in_place();
  const Finished finished = refused(hunt_->wait(), "ccdfuzz: hunt: " + finds_);
  EXPECT_EQ(count_of(finished.err, "the hunt continues"), 1U) << finished.err;
  EXPECT_THAT(finished.out, HasSubstr("missed"));
  EXPECT_THAT(finished.out, HasSubstr("Not stored: "));
  EXPECT_EQ(read_text(finds_), "no folder");
  // The cases are on standard output instead.
  std::istringstream lines(finished.out);
  size_t cases = 0;
  for (std::string line; std::getline(lines, line);) {
    if (line[0] == '{') write_text(folder_ / fmt::format("away/unstored-{}.json", cases++), line);
  }
  EXPECT_GT(cases, 0U) << finished.out;
  succeeded(ccdfuzz({"replay", away_}));
}

}  // namespace
}  // namespace ccdfuzz
