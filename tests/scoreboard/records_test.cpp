#include "records.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

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
  r.driver = Driver::kHunt, r.fault = kFault.name, r.seed = seed, r.limit = 10, r.found = "x";
  return r;
}

const std::string kHeaderLine =
    R"({"format":"ccdfuzz-run","version":1,"run":"scoreboard","ccdfuzz":"","inputs":[],"asked":{},)"
    R"("items":0,"shard":{"index":0,"of":1}})"
    "\n";

/// A line that tells nothing of what the fault was, as some are.
std::string old_line(std::uint64_t seed) {
  return to_json(record_of(seed)) + "\n";
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

TEST(Records, AreThereAgainWhereTheCampaignEnded) {
  const ScratchFolder folder;
  const std::string path = folder / "r";
  write_text(path, kHeaderLine + old_line(1));
  ASSERT_TRUE(Records::open(path, kFaults, Use::kExtend).value().add(record_of(2)));
  EXPECT_EQ(folder.entry_count(), 1);
  EXPECT_THAT(read_text(path), StartsWith(kHeaderLine + old_line(1)));
  const auto again = Records::open(path, kFaults, Use::kRead);
  ASSERT_TRUE(again) << again.error().message();
  EXPECT_EQ(again->all().size(), 2);
  const Record* second = again->find(Driver::kHunt, kFault.name, 2, 10);
  ASSERT_NE(second, nullptr);
  EXPECT_EQ(second->definition, definition_hash(kFault));
  EXPECT_EQ(second->found, "x");
}

TEST(Records, AreThereAgainWhereTheCampaignWasKilled) {
  const ScratchFolder folder;
  const std::string path = folder / "r";
  for (const std::uint64_t seed : {1, 2}) {
    ASSERT_TRUE(Records::open(path, kFaults, Use::kExtend).value().add(record_of(seed)));
  }
  std::filesystem::resize_file(path, std::filesystem::file_size(path) - 1);
  const std::string text = read_text(path);
  const auto records = Records::open(path, kFaults, Use::kRead);
  ASSERT_TRUE(records) << records.error().message();
  EXPECT_NE(records->find(Driver::kHunt, kFault.name, 1, 10), nullptr);
  EXPECT_EQ(records->find(Driver::kHunt, kFault.name, 2, 10), nullptr);
  EXPECT_EQ(read_text(path), text);
  ASSERT_TRUE(Records::open(path, kFaults, Use::kExtend).value().add(record_of(3)));
  EXPECT_EQ(Records::open(path, kFaults, Use::kRead)->all().size(), 2);
}

TEST(Records, AreReadWhileACampaignRuns) {
  const ScratchFolder folder;
  auto running = Records::open(folder / "r", kFaults, Use::kExtend);
  ASSERT_TRUE(running && running->add(record_of(1)));
  const auto seen = Records::open(folder / "r", kFaults, Use::kRead);
  ASSERT_TRUE(seen) << seen.error().message();
  EXPECT_NE(seen->find(Driver::kHunt, kFault.name, 1, 10), nullptr);
  ASSERT_TRUE(running->add(record_of(2)));
  EXPECT_EQ(Records::open(folder / "r", kFaults, Use::kRead)->all().size(), 2);
}

TEST(Records, RefuseWhatIsNoneNamingLineFieldAndValue) {
  const std::string good = old_line(1);
  const std::vector<std::array<std::string, 3>> wrong = {
      {R"("hunt")", R"("nosuch")", R"(r:3: driver: "nosuch" is none of random, )"},
      {R"("a.fault")", R"("gone")", R"(r:3: fault: "gone" is not in the list of faults)"},
      {R"("seed":1)", R"("seed":0)", "r:3: seed: 0 is not a seed"},
      {R"("seed":1)", R"("seed":-1)", "r:3: seed: -1 is outside 0.."},
      {R"("limit":10)", R"("limit":0.0)", "r:3: limit: 0.0 is not > 0"},
      {R"("limit":10)", R"("limit":-5)", "r:3: limit: -5 is not > 0"},
      {R"("detected":false,)", "", "r:3: detected: missing"},
      {R"("found":)", R"("gone":1,"found":)", "r:3: gone: unknown key"},
      {R"("found":)", R"("Found":"","found":)", "r:3: Found: unknown key"}};
  for (const auto& [from, to, message] : wrong) {
    EXPECT_THAT(refusal_of(kHeaderLine + good + with(good, from, to)), StartsWith(message));
  }
  EXPECT_EQ(refusal_of(kHeaderLine + good + good), "");
  EXPECT_THAT(refusal_of(good), StartsWith("r: is not the file of this run"));
  EXPECT_THAT(refusal_of(with(kHeaderLine, "scoreboard", "hunt")),
              StartsWith("r: belongs to a run with run hunt in place of"));
}

TEST(Records, AreLeftOutWhenTheirFaultHasChanged) {
  const ScratchFolder folder;
  const std::string path = folder / "r";
  for (const std::uint64_t seed : {1, 2}) {
    ASSERT_TRUE(Records::open(path, kFaults, Use::kExtend).value().add(record_of(seed)));
  }
  const auto with_field = [](std::string PlantedFault::*field) {
    std::vector<PlantedFault> list = kFaults;
    list[0].*field += " ";
    return list;
  };
  for (const auto field : {&PlantedFault::file, &PlantedFault::from, &PlantedFault::to}) {
    auto others = Records::open(path, with_field(field), Use::kRead);
    ASSERT_TRUE(others) << others.error().message();
    EXPECT_TRUE(others->all().empty());
    EXPECT_EQ(others->outdated(), 2);
    ASSERT_TRUE(others->add(record_of(1)));
    EXPECT_EQ(others->outdated(), 1);
  }
  const std::vector<PlantedFault> renamed = with_field(&PlantedFault::what);
  EXPECT_EQ(Records::open(path, renamed, Use::kRead)->all().size(), 2);
  write_text(path, kHeaderLine + old_line(1));
  EXPECT_EQ(Records::open(path, with_field(&PlantedFault::to), Use::kRead)->all().size(), 1);
}

TEST(Records, AreLeftOutWhenTheyWatchedOtherFaults) {
  const ScratchFolder folder;
  const std::string path = folder / "r";
  Record watched = record_of(1);
  watched.fault = kWatchedFaults;
  ASSERT_TRUE(Records::open(path, kFaults, Use::kExtend).value().add(watched));
  EXPECT_EQ(Records::open(path, kFaults, Use::kRead)->all().size(), 1);
  std::vector<PlantedFault> more = kFaults;
  more.push_back(kFault);
  more.back().name = "b.fault";
  const auto others = Records::open(path, more, Use::kRead);
  ASSERT_TRUE(others) << others.error().message();
  EXPECT_EQ(others->find(Driver::kHunt, kWatchedFaults, 1, 10), nullptr);
  EXPECT_EQ(others->outdated(), 1);
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
