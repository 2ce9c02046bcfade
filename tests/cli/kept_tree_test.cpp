// A proof of absence by a tree of separating axes stays with its case, whatever moves the case.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "files/case_files.hpp"
#include "files/case_json.hpp"
#include "files/tree_file.hpp"
#include "process.hpp"

namespace ccdfuzz {
namespace {

using testing::HasSubstr;

class KeptTree : public testing::Test {
 protected:
  /// Corpora "plain" and "named" of one near-miss each, the same one, whose absence of contact is
  /// proven by a tree. At precision 1 tdibm says that there is a contact.
  KeptTree() {
    const std::string set = generated(folder_, "VF", "NMN", 1), proven = folder_ / "proven.json";
    succeeded(ccdfuzz({"prove", set, "-o", proven}));
    auto found = read_case(proven);
    EXPECT_TRUE(found && found->value.truth.proof == "T");
    for (const char* name : {"plain", "named"}) {
      std::filesystem::create_directories(folder_ / name);
      found->value.origin.name = name[0] == 'n' ? "near-miss" : "";
      found->value.asked.precision = 1;
      found->value.expect = {{"tdibm", Outcome::kFalsePositive}};
      write_text(case_in(name), to_json(found->value));
      std::filesystem::copy_file(trees_path(proven), trees_path(case_in(name)));
    }
  }
  std::string case_in(const std::string& corpus) const {
    return folder_ / (corpus + "/near-miss.json");
  }
  void expect_proven(const std::string& corpus) const {
    const Finished replayed = succeeded(ccdfuzz({"replay", corpus}));
    EXPECT_THAT(replayed.out, HasSubstr("1 entry, 1 expectation: all as expected"));
    EXPECT_EQ(replayed.err, "");
  }

  const ScratchFolder folder_;
};

TEST_F(KeptTree, StaysWithAMergedEntry) {
  const std::string all = folder_ / "all";
  succeeded(ccdfuzz({"merge", folder_ / "plain", "-o", all}));
  expect_proven(all);
}

TEST_F(KeptTree, StaysWhenAnEntryMeetsItselfWithoutProof) {
  std::filesystem::create_directories(folder_ / "weak");
  auto entry = read_case(case_in("plain"));
  drop_tree(entry->value.truth);
  write_text(case_in("weak"), to_json(entry->value));
  const std::string plain = folder_ / "plain", weak = folder_ / "weak";
  for (const bool plain_first : {false, true}) {
    const std::string all = folder_ / (plain_first ? "all" : "also");
    const auto& [first, second] = plain_first ? std::pair(plain, weak) : std::pair(weak, plain);
    succeeded(ccdfuzz({"merge", first, second, "-o", all}));
    expect_proven(all);
  }
  succeeded(ccdfuzz({"merge", plain, "-o", weak}));
  expect_proven(weak);
}

TEST_F(KeptTree, StaysWithAnEntryThatGetsAName) {
  const std::string all = folder_ / "all";
  succeeded(ccdfuzz({"merge", folder_ / "plain", folder_ / "named", "-o", all}));
  expect_proven(all);
  size_t files = 0;
  for (const auto& file : std::filesystem::directory_iterator(all)) {
    EXPECT_THAT(file.path().filename().string(), testing::StartsWith("near-miss.")) << "is left";
    ++files;
  }
  EXPECT_EQ(files, 2U);
}

TEST_F(KeptTree, StaysWithACaseThatMinimizeCannotChange) {
  const std::string small = folder_ / "small.json";
  const Finished done =
      succeeded(ccdfuzz({"minimize", case_in("plain"), "--method", "tdibm", "-o", small}));
  EXPECT_THAT(done.err, HasSubstr("false_positive by tdibm"));
  const Finished verified = ccdfuzz({"verify", small});
  EXPECT_EQ(verified.out, "1 case: 1 hold, 0 refuted, 0 unproven\n");
  const Finished shown = succeeded(ccdfuzz({"minimize", case_in("plain"), "--method", "tdibm"}));
  EXPECT_THAT(shown.err, HasSubstr("which stdout cannot hold"));
}

TEST_F(KeptTree, IsNotReadFromAPipe) {
  const std::string trees = trees_path(case_in("plain"));
  std::filesystem::remove(trees);
  ASSERT_EQ(::mkfifo(trees.c_str(), 0600), 0);
  const Finished verified =
      failed(shell(fmt::format("timeout 60 \"$ccdfuzz\" verify {}", case_in("plain"))));
  EXPECT_THAT(verified.out, HasSubstr("near-miss.trees.zst: is not a regular file"));
}

TEST_F(KeptTree, OrACorpusWithAPipeAmongItsEntriesIsRefused) {
  const std::string pipe = folder_ / "plain/pipe", link = folder_ / "plain/link.json";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  std::filesystem::create_symlink("pipe", link);
  refused(shell(fmt::format("timeout 60 \"$ccdfuzz\" replay {}", folder_ / "plain")),
          link + ": is not a regular file");
}

TEST_F(KeptTree, EvaluateAsksACaseAtItsOwnPrecision) {
  const auto rate = [&](std::vector<std::string> more) {
    more.insert(more.begin(), {"evaluate", case_in("plain"), "--methods", "tdibm", "--json"});
    const auto rows = json_lines(ccdfuzz(more).out);
    return rows.empty() ? -1 : rows[0].at("false_positive").get<int>();
  };
  EXPECT_EQ(rate({}), 1);
  EXPECT_EQ(rate({"-o", folder_ / "run"}), 1);
  EXPECT_EQ(rate({"--precision", "1e-9"}), 0);
}

}  // namespace
}  // namespace ccdfuzz
