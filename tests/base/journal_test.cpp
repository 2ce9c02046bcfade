#include "base/journal.hpp"

#include <gtest/gtest.h>

#include <filesystem>

#include "scratch_folder.hpp"

namespace ccdfuzz {
namespace {

const Journal::Header kRun = {{"run", "test"}, {"--seed", "7"}};

std::vector<std::string> records_of(const Journal& journal) {
  std::vector<std::string> records;
  EXPECT_TRUE(journal.for_each([&](std::string_view record) -> Result<void> {
    records.emplace_back(record);
    return {};
  }));
  return records;
}

class JournalTest : public testing::Test {
 protected:
  Journal open(const Journal::Header& header = kRun) {
    Result<Journal> journal = Journal::open(path_, header);
    if (!journal) throw std::runtime_error(journal.error().message());
    return *std::move(journal);
  }
  void fill(const std::vector<std::string>& records) {
    Journal journal = open();
    for (const std::string& record : records) ASSERT_TRUE(journal.append(record));
  }

  ScratchFolder folder_;
  std::string path_ = folder_ / "x.partial";
  const std::vector<std::string> records_ = {"first", "", std::string("bi\0nary\n", 8), "last"};
};

TEST_F(JournalTest, KeepsRecordsOverRuns) {
  fill(records_);
  EXPECT_EQ(open().size(), records_.size());
  fill({"more"});
  const std::vector<std::string> all = records_of(open());
  EXPECT_EQ(all.size(), 5U);
  EXPECT_EQ(std::vector(all.begin(), all.begin() + 4), records_);
}

// What a kill leaves is a beginning of the file, of any length.
TEST_F(JournalTest, GoesOnBehindTheLastWholeRecordWhereverItWasCutOff) {
  fill(records_);
  const std::string whole = read_text(path_);
  size_t before = 0;
  for (size_t length = 0; length <= whole.size(); ++length) {
    write_text(path_, whole.substr(0, length));
    {
      Journal journal = open();
      const size_t left = journal.size();
      EXPECT_GE(left, before);
      EXPECT_LE(left, records_.size());
      before = left;
      EXPECT_EQ(records_of(journal), std::vector(records_.begin(), records_.begin() + left));
      for (size_t i = left; i < records_.size(); ++i) ASSERT_TRUE(journal.append(records_[i]));
    }
    EXPECT_EQ(read_text(path_), whole) << "cut to " << length;
  }
  EXPECT_EQ(before, records_.size());
}

TEST_F(JournalTest, ADamagedRecordAndWhatFollowsAreDoneAgain) {
  fill(records_);
  std::string bytes = read_text(path_);
  bytes[bytes.find("nary")] ^= 1;
  write_text(path_, bytes);
  EXPECT_EQ(records_of(open()), std::vector(records_.begin(), records_.begin() + 2));
}

TEST_F(JournalTest, RefusesTheJournalOfAnotherRunAndNamesWhatDiffers) {
  fill(records_);
  const std::string before = read_text(path_);
  const auto refusal = [&](const Journal::Header& header) {
    const Result<Journal> other = Journal::open(path_, header);
    return other ? "" : other.error().message();
  };
  const std::string seed = refusal({{"run", "test"}, {"--seed", "8"}});
  EXPECT_NE(seed.find(path_), std::string::npos) << seed;
  EXPECT_NE(seed.find("--seed 7"), std::string::npos) << seed;
  EXPECT_NE(seed.find("8"), std::string::npos) << seed;
  EXPECT_NE(refusal({{"run", "test"}}), "");
  EXPECT_NE(refusal({{"run", "test"}, {"--seed", "7"}, {"--shard", "0/2"}}), "");
  EXPECT_EQ(read_text(path_), before);
  write_text(path_, "{}\n");
  EXPECT_NE(refusal(kRun).find("is not the journal"), std::string::npos) << refusal(kRun);
  EXPECT_EQ(read_text(path_), "{}\n");
}

TEST_F(JournalTest, OneProcessAtATime) {
  const Journal first = open();
  const Result<Journal> second = Journal::open(path_, kRun);
  ASSERT_FALSE(second);
  EXPECT_NE(second.error().message().find("another process"), std::string::npos);
}

TEST_F(JournalTest, IsReadWhileItsRunGoesOnAndStaysAsItIs) {
  fill(records_);
  Journal running = open();
  write_text(folder_ / "x", read_text(path_));
  std::filesystem::resize_file(path_, std::filesystem::file_size(path_) - 1);
  const auto seen = Journal::read(path_, kRun);
  ASSERT_TRUE(seen) << seen.error().message();
  EXPECT_EQ(*seen, std::vector(records_.begin(), records_.begin() + 3));
  EXPECT_EQ(std::filesystem::file_size(path_) + 1, std::filesystem::file_size(folder_ / "x"));
  const auto other = Journal::read(path_, {{"run", "other"}});
  ASSERT_FALSE(other);
  EXPECT_NE(other.error().message().find("belongs to a run with run test"), std::string::npos);
  EXPECT_FALSE(Journal::read(folder_ / "nosuch", kRun));
}

TEST_F(JournalTest, RemoveTakesItAway) {
  Journal journal = open();
  ASSERT_TRUE(journal.remove());
  EXPECT_FALSE(std::filesystem::exists(path_));
}

}  // namespace
}  // namespace ccdfuzz
