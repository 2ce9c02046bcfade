#include "records.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "fault_hash.hpp"
#include "record_line.hpp"
#include "scratch_folder.hpp"

namespace ccdfuzz {
namespace {

using testing::HasSubstr;
using testing::StartsWith;
using Use = Records::Use;

const PlantedFault kFault = {"a.fault", "what", "a.hpp", false, "x", "y", ""};
const std::vector<PlantedFault> kFaults = {kFault};

Record record_of(std::uint64_t seed) {
  Record r;
  r.driver = "hunt", r.fault = kFault.name, r.seed = seed, r.limit = 10, r.found = "x";
  return r;
}

/// A line of an older file, which tells nothing of what the fault was.
std::string old_line(std::uint64_t seed) {
  return to_line(record_of(seed)) + "\n";
}

std::string refusal_of(const std::string& text) {
  const ScratchFolder folder;
  write_text(folder / "r", text);
  const auto records = Records::open(folder / "r", kFaults, Use::kExtend);
  return records ? "" : records.error().message().substr(folder.path().size() + 1);
}

std::string with(std::string line, const std::string& from, const std::string& to) {
  return line.replace(line.find(from), from.size(), to);
}

TEST(Records, AreThereAgainWhereTheCampaignFinished) {
  const ScratchFolder folder;
  const std::string path = folder / "r";
  write_text(path, old_line(1));
  {
    auto records = Records::open(path, kFaults, Use::kExtend);
    ASSERT_TRUE(records) << records.error().message();
    ASSERT_TRUE(records->add(record_of(2)));
    ASSERT_TRUE(records->finish());
  }
  EXPECT_EQ(folder.entry_count(), 1);
  EXPECT_THAT(read_text(path), StartsWith(old_line(1)));
  const auto again = Records::open(path, kFaults, Use::kRead);
  ASSERT_TRUE(again) << again.error().message();
  EXPECT_EQ(again->all().size(), 2);
  const Record* second = again->find("hunt", kFault.name, 2, 10);
  ASSERT_NE(second, nullptr);
  EXPECT_EQ(second->definition, definition_hash(kFault));
  EXPECT_EQ(second->found, "x");
}

TEST(Records, AreThereAgainWhereTheCampaignWasKilled) {
  const ScratchFolder folder;
  const std::string path = folder / "r";
  for (const std::uint64_t seed : {1, 2}) {
    auto records = Records::open(path, kFaults, Use::kExtend);
    ASSERT_TRUE(records) << records.error().message();
    ASSERT_TRUE(records->add(record_of(seed)));
  }
  std::filesystem::resize_file(RunFile::path_for(path),
                               std::filesystem::file_size(RunFile::path_for(path)) - 1);
  auto records = Records::open(path, kFaults, Use::kRead);
  ASSERT_TRUE(records) << records.error().message();
  EXPECT_NE(records->find("hunt", kFault.name, 1, 10), nullptr);
  EXPECT_EQ(records->find("hunt", kFault.name, 2, 10), nullptr);
  ASSERT_TRUE(records->finish());
  EXPECT_FALSE(std::filesystem::exists(path));
  auto begun_again = Records::open(path, kFaults, Use::kExtend);
  ASSERT_TRUE(begun_again && begun_again->finish());
  EXPECT_EQ(folder.entry_count(), 1);
  EXPECT_EQ(Records::open(path, kFaults, Use::kRead)->all().size(), 1);
}

TEST(Records, AreReadAndLeftInPlaceWhileACampaignRuns) {
  const ScratchFolder folder;
  const std::string path = folder / "r", journal = RunFile::path_for(path);
  auto running = Records::open(path, kFaults, Use::kExtend);
  ASSERT_TRUE(running && running->add(record_of(1)));
  const std::string text = read_text(journal);
  auto seen = Records::open(path, kFaults, Use::kRead);
  ASSERT_TRUE(seen) << seen.error().message();
  EXPECT_NE(seen->find("hunt", kFault.name, 1, 10), nullptr);
  ASSERT_TRUE(seen->finish());
  EXPECT_EQ(folder.entry_count(), 1);
  EXPECT_EQ(read_text(journal), text);
  ASSERT_TRUE(running->add(record_of(2)) && running->finish());
  EXPECT_EQ(Records::open(path, kFaults, Use::kRead)->all().size(), 2);
}

TEST(Records, AreNotThereTwiceWhereItWasKilledAtItsEnd) {
  const ScratchFolder folder;
  const std::string path = folder / "r", journal = RunFile::path_for(path);
  auto first = Records::open(path, kFaults, Use::kExtend);
  ASSERT_TRUE(first && first->add(record_of(1)));
  std::filesystem::copy_file(journal, folder / "copy");
  ASSERT_TRUE(first->finish());
  const std::string text = read_text(path);
  std::filesystem::rename(folder / "copy", journal);
  auto second = Records::open(path, kFaults, Use::kExtend);
  ASSERT_TRUE(second && second->finish());
  EXPECT_EQ(read_text(path), text);
}

TEST(Records, KeepWhatOthersPutThereMeanwhile) {
  const ScratchFolder folder;
  auto records = Records::open(folder / "r", kFaults, Use::kExtend);
  ASSERT_TRUE(records && records->add(record_of(1)));
  write_text(folder / "r", old_line(5));
  ASSERT_TRUE(records->finish());
  EXPECT_THAT(read_text(folder / "r"), StartsWith(old_line(5)));
  EXPECT_EQ(Records::open(folder / "r", kFaults, Use::kRead)->all().size(), 2);
}

TEST(Records, AnUnfinishedLastLineIsLeftOut) {
  const ScratchFolder folder;
  const std::string path = folder / "r", whole = old_line(2);
  for (std::size_t kept = 0; kept < whole.size(); ++kept) {
    write_text(path, old_line(1) + whole.substr(0, kept));
    auto records = Records::open(path, kFaults, Use::kExtend);
    ASSERT_TRUE(records) << records.error().message();
    EXPECT_EQ(records->all().size(), kept + 1 < whole.size() ? 1 : 2) << kept;
    ASSERT_TRUE(records->add(record_of(3)) && records->finish());
    const auto again = Records::open(path, kFaults, Use::kRead);
    ASSERT_TRUE(again) << again.error().message();
    EXPECT_EQ(again->all().size(), kept + 1 < whole.size() ? 2 : 3) << kept;
  }
  EXPECT_THAT(refusal_of("{\n" + old_line(1)), StartsWith("r:1:"));
}

TEST(Records, RefuseWhatIsNoneNamingLineFieldAndValue) {
  const std::string good = old_line(1);
  const std::vector<std::array<std::string, 3>> wrong = {
      {R"("hunt")", R"("nosuch")", R"(r:2: driver: "nosuch" is not a driver)"},
      {R"("a.fault")", R"("gone")", R"(r:2: fault: "gone" is not in the list of faults)"},
      {R"("seed":1)", R"("seed":0)", "r:2: seed: 0 is not a seed"},
      {R"("seed":1)", R"("seed":-1)", "r:2: seed: -1 is outside 0.."},
      {R"("limit":10)", R"("limit":0.0)", "r:2: limit: 0.0 is not > 0"},
      {R"("limit":10)", R"("limit":-5)", "r:2: limit: -5 is not > 0"},
      {R"("detected":false,)", "", "r:2: detected: missing"},
      {R"("found":)", R"("gone":1,"found":)", "r:2: gone: unknown key"},
      {R"("found":)", R"("Found":"","found":)", "r:2: Found: unknown key"}};
  for (const auto& [from, to, message] : wrong) {
    EXPECT_THAT(refusal_of(good + with(good, from, to)), StartsWith(message));
  }
  EXPECT_EQ(refusal_of(good + good), "");
}

TEST(Records, AreLeftOutWhenTheirFaultHasChanged) {
  const ScratchFolder folder;
  const std::string path = folder / "r";
  auto records = Records::open(path, kFaults, Use::kExtend);
  ASSERT_TRUE(records && records->add(record_of(1)) && records->add(record_of(2)));
  ASSERT_TRUE(records->finish());
  const auto with_field = [](std::string PlantedFault::*field) {
    std::vector<PlantedFault> list = kFaults;
    list[0].*field += " ";
    return list;
  };
  for (const auto field : {&PlantedFault::file, &PlantedFault::from, &PlantedFault::to}) {
    const std::vector<PlantedFault> list = with_field(field);
    auto others = Records::open(path, list, Use::kExtend);
    ASSERT_TRUE(others) << others.error().message();
    EXPECT_TRUE(others->all().empty());
    EXPECT_EQ(others->outdated(), 2);
    ASSERT_TRUE(others->add(record_of(1)));
    EXPECT_EQ(others->outdated(), 1);
  }
  const std::vector<PlantedFault> renamed = with_field(&PlantedFault::what);
  EXPECT_EQ(Records::open(path, renamed, Use::kRead)->all().size(), 2);
  write_text(path, old_line(1));
  EXPECT_EQ(Records::open(path, with_field(&PlantedFault::to), Use::kRead)->all().size(), 1);
}

TEST(Records, AreLeftOutWhenTheyWatchedOtherFaults) {
  const ScratchFolder folder;
  const std::string path = folder / "r";
  Record watched = record_of(1);
  watched.fault = kWatchedFaults;
  auto records = Records::open(path, kFaults, Use::kExtend);
  ASSERT_TRUE(records && records->add(watched) && records->finish());
  EXPECT_EQ(Records::open(path, kFaults, Use::kRead)->all().size(), 1);
  std::vector<PlantedFault> more = kFaults;
  more.push_back(kFault);
  more.back().name = "b.fault";
  const auto others = Records::open(path, more, Use::kRead);
  ASSERT_TRUE(others) << others.error().message();
  EXPECT_EQ(others->find("hunt", kWatchedFaults, 1, 10), nullptr);
  EXPECT_EQ(others->outdated(), 1);
}

TEST(Records, LeaveNoJournalWhenTheyAreRefused) {
  const ScratchFolder folder;
  write_text(folder / "r", "{\n" + old_line(1));
  EXPECT_FALSE(Records::open(folder / "r", kFaults, Use::kExtend));
  EXPECT_EQ(folder.entry_count(), 1);
}

TEST(Records, FailAtOnceWhenTheirFileCannotBeWritten) {
  const ScratchFolder folder;
  std::filesystem::create_directory(folder / "d");
  EXPECT_FALSE(Records::open(folder / "d", kFaults, Use::kExtend));
  EXPECT_FALSE(Records::open(folder / "nosuch/r", kFaults, Use::kExtend));
  EXPECT_FALSE(Records::open(folder / "nosuch", kFaults, Use::kRead));
  auto one = Records::open(folder / "r", kFaults, Use::kExtend);
  ASSERT_TRUE(one);
  const auto other = Records::open(folder / "r", kFaults, Use::kExtend);
  ASSERT_FALSE(other);
  EXPECT_THAT(other.error().message(), HasSubstr("another process"));
}

}  // namespace
}  // namespace ccdfuzz
