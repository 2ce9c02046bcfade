#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "process.hpp"

namespace ccdfuzz {
namespace {

using testing::HasSubstr;

const std::string kCorpus = CCDFUZZ_SOURCE_DIR "/corpus/regressions/";
const std::string kCase = kCorpus + "tdibm-e-underflow.json";

TEST(ExportGltf, WritesOneFileOrAFolder) {
  const ScratchFolder folder;
  const Finished one = ccdfuzz({"export", kCase, "--as", "gltf", "-o", folder / "a.gltf"});
  EXPECT_EQ(one.code, 0) << one.err;
  EXPECT_EQ(nlohmann::json::parse(read_text(folder / "a.gltf"))["animations"].size(), 1U);
  const Finished two = ccdfuzz({"export", kCase, kCorpus + "tdibm-e-overflow.json", "--as", "gltf",
                                "--times", "0,2^-1", "-o", folder / "all"});
  EXPECT_EQ(two.code, 0) << two.err;
  EXPECT_THAT(read_text(folder / "all/tdibm-e-underflow.gltf"), HasSubstr("patch 1 at t = 0.5"));
  EXPECT_THAT(two.out, HasSubstr("all/tdibm-e-overflow.gltf"));
}

TEST(ExportGltf, RefusesSeveralCasesForOneFile) {
  const ScratchFolder folder;
  const Finished refused =
      ccdfuzz({"export", kCase, kCase, "--as", "gltf", "-o", folder / "a.gltf"});
  EXPECT_EQ(refused.code, 2);
  EXPECT_THAT(refused.err, HasSubstr("a.gltf: takes one case, not 2"));
  EXPECT_FALSE(std::filesystem::exists(folder / "a.gltf"));
  EXPECT_EQ(ccdfuzz({"export", kCase, "--as", "gltf", "--times", "x", "-o", folder / "b"}).code, 2);
}

}  // namespace
}  // namespace ccdfuzz
