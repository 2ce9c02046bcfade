#include <gtest/gtest.h>

#include "process.hpp"

namespace ccdfuzz {
namespace {

std::vector<std::string> generate(const std::string& contact, const std::string& kind,
                                  std::vector<std::string> more) {
  std::vector<std::string> arguments = {"generate", "--contact", contact, "--kind", kind};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

TEST(Generate, SameSeedSameBytesOnAnyNumberOfThreads) {
  for (const char* construction : {"paper", "one-sided"}) {
    for (const char* contact : {"FF", "VV"}) {
      std::vector<std::string> outputs;
      for (const char* threads : {"1", "2", "7"}) {
        const Finished made = ccdfuzz(generate(contact, "RP",
                                               {"--count", "10", "--seed", "5", "--construction",
                                                construction, "--threads", threads}));
        EXPECT_EQ(made.code, 0) << made.err;
        outputs.push_back(made.out);
      }
      EXPECT_EQ(json_lines(outputs[0]).size(), 10U);
      EXPECT_EQ(outputs[0], outputs[1]) << construction << " " << contact;
      EXPECT_EQ(outputs[0], outputs[2]) << construction << " " << contact;
    }
  }
}

TEST(Generate, AnyCaseOfARunCanBeMadeAlone) {
  const std::string all = ccdfuzz(generate("VE", "RP", {"--count", "6"})).out;
  const std::string alone = ccdfuzz(generate("VE", "RP", {"--count", "1", "--first", "4"})).out;
  EXPECT_FALSE(alone.empty());
  EXPECT_EQ(json_lines(all).at(4).dump(), json_lines(alone).at(0).dump());
}

TEST(Generate, AnotherSeedGivesOtherCases) {
  const std::string a = ccdfuzz(generate("VV", "RP", {"--count", "1", "--seed", "1"})).out;
  const std::string b = ccdfuzz(generate("VV", "RP", {"--count", "1", "--seed", "2"})).out;
  EXPECT_NE(json_lines(a).at(0).at("patches"), json_lines(b).at(0).at("patches"));
}

TEST(Generate, FilesHoldWhatStdoutShows) {
  const ScratchFolder folder;
  const std::string path = folder / "set.jsonl";
  const std::string shown = ccdfuzz(generate("EE", "RN", {"--count", "3"})).out;
  EXPECT_EQ(ccdfuzz(generate("EE", "RN", {"--count", "3", "-o", path})).code, 0);
  EXPECT_EQ(read_text(path), shown);
}

TEST(Generate, EpsTIsWhereANegativeCaseEnds) {
  const auto rows =
      json_lines(ccdfuzz(generate("VV", "RN", {"--count", "1", "--eps-t", "2^-10"})).out);
  const auto positive = json_lines(ccdfuzz(generate("VV", "RP", {"--count", "1"})).out);
  ASSERT_EQ(rows.size(), 1U);
  EXPECT_EQ(rows[0].at("t_max").get<double>(), positive[0].at("t_max").get<double>() - 0x1p-10);
  EXPECT_EQ(rows[0].at("truth").at("collides"), false);
}

TEST(Generate, SaysWhatItDiscardedOnStderr) {
  const Finished made = ccdfuzz(generate("FF", "RP", {"--count", "2"}));
  for (const char* reason : {"static check", "first contact", "round trip", "each"}) {
    EXPECT_NE(made.err.find(reason), std::string::npos) << made.err;
  }
}

TEST(Generate, JsonGivesTheSummaryWhereTheCasesGoToAFile) {
  const ScratchFolder folder;
  const Finished made =
      ccdfuzz(generate("FF", "RP", {"--count", "2", "--json", "-o", folder / "set.jsonl"}));
  EXPECT_EQ(made.code, 0) << made.err;
  EXPECT_EQ(made.err, "");
  const auto rows = json_lines(made.out);
  ASSERT_EQ(rows.size(), 1U);
  EXPECT_EQ(rows[0].at("cases"), 2);
  std::uint64_t begun = 2;
  for (const auto& [reason, count] : rows[0].at("discarded").items()) {
    begun += count.get<std::uint64_t>();
  }
  EXPECT_EQ(rows[0].at("begun"), begun);
  EXPECT_EQ(ccdfuzz(generate("FF", "RP", {"--count", "2", "--json"})).code, 2);
}

TEST(Generate, AStressFamilyIsMadeByItsName) {
  const auto rows =
      json_lines(ccdfuzz(generate("VV", "RP", {"--count", "2", "--family", "twins"})).out);
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[0].at("origin").at("generator"), "twins");
  EXPECT_EQ(ccdfuzz(generate("VV", "RN", {"--count", "2", "--family", "twins"})).code, 2);
}

TEST(Generate, ShapesAreNamedForBothPatchesOrEach) {
  const Finished made =
      ccdfuzz(generate("VF", "RN", {"--count", "2", "--shape", "point,tensor:2x3"}));
  EXPECT_EQ(made.code, 0) << made.err;
  for (const auto& row : json_lines(made.out)) {
    EXPECT_EQ(row.at("patches").at(0).at("shape"), "point");
    EXPECT_EQ(row.at("patches").at(1).at("degree").dump(), "[2,3]");
    EXPECT_EQ(row.at("truth").at("proof"), "P");
  }
  for (const char* bad : {"blob", "triangle", "triangle:0", "triangle:9", "tensor:2", "curve:2x",
                          "point,", "triangle:2,triangle:2,triangle:2"}) {
    const Finished refused = ccdfuzz(generate("VV", "RP", {"--count", "1", "--shape", bad}));
    EXPECT_EQ(refused.code, 2) << bad;
    EXPECT_NE(refused.err.find("--shape"), std::string::npos) << refused.err;
  }
}

TEST(Generate, CtrlCLeavesNoFileBehind) {
  const ScratchFolder folder;
  Process process(generate("VV", "RP", {"--count", "1000000000", "-o", folder / "set.jsonl"}));
  while (std::filesystem::is_empty(folder.path())) std::this_thread::yield();
  process.signal(SIGINT);
  const Finished finished = process.wait();
  EXPECT_EQ(finished.code, 128 + SIGINT);
  EXPECT_NE(finished.err.find("set.jsonl was not written"), std::string::npos) << finished.err;
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(Generate, AFullDiskLeavesNothingBehind) {
  const Finished made = ccdfuzz(generate("VV", "RP", {"--count", "5", "-o", "/dev/full"}));
  EXPECT_EQ(made.code, 2);
  EXPECT_NE(made.err.find("/dev/full"), std::string::npos) << made.err;
  EXPECT_NE(made.err.find("No space left on device"), std::string::npos) << made.err;
}

}  // namespace
}  // namespace ccdfuzz
