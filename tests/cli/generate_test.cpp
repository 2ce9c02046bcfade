#include <gtest/gtest.h>

#include "process.hpp"

namespace ccdfuzz {
namespace {

std::vector<std::string> generate(const std::string& contact, const std::string& kind,
                                  std::vector<std::string> more) {
  return with({"generate", "--contact", contact, "--kind", kind}, more);
}

TEST(Generate, AnyCaseOfARunCanBeMadeAlone) {
  const std::string all = ccdfuzz(generate("VE", "RP", {"--count", "6"})).out;
  const std::string alone = ccdfuzz(generate("VE", "RP", {"--count", "1", "--first", "4"})).out;
  EXPECT_FALSE(alone.empty());
  EXPECT_EQ(json_lines(all).at(4).dump(), json_lines(alone).at(0).dump());
}

TEST(Generate, CtrlCLeavesNoFileBehind) {
  const ScratchFolder folder;
  Process process(generate("VV", "RP", {"--count", "1000000000", "-o", folder / "set.jsonl"}));
  while (std::filesystem::is_empty(folder.path())) std::this_thread::yield();
  process.signal(SIGINT);
  const Finished finished = process.wait();
  EXPECT_EQ(finished.code, 128 + SIGINT);
  EXPECT_THAT(finished.err, testing::HasSubstr("set.jsonl was not written"));
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

}  // namespace
}  // namespace ccdfuzz
