#include "files/tree_file.hpp"

#include <gmock/gmock.h>

#include "scratch_folder.hpp"

namespace ccdfuzz {
namespace {

TEST(TreeFile, StandsBesideItsCaseFile) {
  EXPECT_EQ(trees_path("a/X.json"), "a/X.trees.zst");
  EXPECT_EQ(trees_path("S.jsonl"), "S.trees.zst");
  EXPECT_EQ(trees_path("S.jsonl.zst"), "S.trees.zst");
  EXPECT_EQ(trees_path("S.csv"), "S.csv.trees.zst");
  EXPECT_EQ(path_beside("a/X.json", ".generation.jsonl"), "a/X.generation.jsonl");
}

class TreeFiles : public testing::Test {
 protected:
  TreeFiles() {
    TreeWriter writer(folder / "X.jsonl");
    for (size_t i = 0; i < 3; ++i) refs[i] = *writer.write(trees[i]);
    EXPECT_FALSE(std::filesystem::exists(path)) << "there before it is whole";
    EXPECT_TRUE(writer.finish());
  }
  std::string error(const TreeRef& ref) const {
    const auto read = read_tree(path, ref);
    EXPECT_TRUE(read || read.error().is_limit) << "refutes the case";
    return read ? "none" : read.error().message();
  }

  const ScratchFolder folder;
  const std::string path = folder / "X.trees.zst";
  const std::array<std::string, 3> trees = {"", std::string(1000, 'x'), std::string("\0\1\2", 3)};
  std::array<TreeRef, 3> refs;
};

TEST_F(TreeFiles, GiveBackEachTree) {
  for (size_t i = 0; i < 3; ++i) {
    const auto read = read_tree(path, refs[i]);
    ASSERT_TRUE(read) << read.error().message();
    EXPECT_EQ(*read, trees[i]);
  }
}

TEST_F(TreeFiles, AWrongPlaceIsToldAsSuch) {
  TreeRef ref = refs[1];
  ref.offset = 1 << 20;
  EXPECT_THAT(error(ref), testing::HasSubstr("ends before byte"));
  ref = refs[1];
  ++ref.offset;
  EXPECT_THAT(error(ref), testing::HasSubstr("holds no tree at byte"));
  ref = refs[1];
  --ref.length;
  EXPECT_THAT(error(ref), testing::HasSubstr("holds no tree at byte"));
  ref = refs[1];
  ref.length += refs[2].length;
  EXPECT_THAT(error(ref), testing::HasSubstr("holds no tree at byte"));
  ref.length = std::uint64_t{1} << 62;
  EXPECT_THAT(error(ref), testing::HasSubstr("is larger than any"));
  ref = refs[2];
  ref.xxh3 = refs[1].xxh3;
  EXPECT_THAT(error(ref), testing::HasSubstr("has the hash"));
}

TEST_F(TreeFiles, AnyDamageIsAnError) {
  const std::string whole = read_text(path);
  for (size_t i = 0; i < whole.size(); ++i) {
    std::string damaged = whole;
    damaged[i] = static_cast<char>(damaged[i] ^ 0x10);
    write_text(path, damaged);
    const size_t tree = i < refs[1].offset ? 0 : i < refs[2].offset ? 1 : 2;
    // A flipped bit of the frame's header may leave its contents as they are.
    const auto read = read_tree(path, refs[tree]);
    EXPECT_EQ(read.value_or(trees[tree]), trees[tree]) << "byte " << i;
  }
  for (size_t size = 0; size < whole.size(); ++size) {
    write_text(path, whole.substr(0, size));
    EXPECT_NE(error(refs[2]), "none") << size;
  }
  std::filesystem::remove(path);
  EXPECT_THAT(error(refs[0]), testing::HasSubstr("cannot read: No such file"));
}

}  // namespace
}  // namespace ccdfuzz
