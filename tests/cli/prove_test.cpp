#include <gtest/gtest.h>

#include <filesystem>

#include "files/case_files.hpp"
#include "files/case_json.hpp"
#include "files/tree_file.hpp"
#include "process.hpp"

namespace ccdfuzz {
namespace {

std::vector<NamedCase> cases_of(const std::string& path) {
  auto cases = read_cases(path);
  EXPECT_TRUE(cases) << cases.error().message();
  return cases ? *std::move(cases) : std::vector<NamedCase>();
}

/// The cases of a set without their truth.
std::string bare(const ScratchFolder& folder, const std::string& set) {
  const std::string path = folder / "bare.jsonl";
  std::string text;
  for (NamedCase& c : cases_of(set)) {
    c.value.truth = {};
    text += to_json(c.value) + "\n";
  }
  write_text(path, text);
  return path;
}

TEST(Prove, KeepsEverythingButTheTruth) {
  const ScratchFolder folder;
  const std::string set = generated(folder, "VF", "RN", 3), out = folder / "out.jsonl";
  succeeded(ccdfuzz({"prove", set, "-o", out, "--json"}));
  const auto before = cases_of(set), after = cases_of(out);
  ASSERT_EQ(before.size(), after.size());
  for (size_t i = 0; i < before.size(); ++i) {
    Case a = before[i].value, b = after[i].value;
    EXPECT_EQ(b.truth.collides, false);
    EXPECT_TRUE(b.truth.proof == "T" || b.truth.proof == "P");
    EXPECT_GE(*b.truth.clear_until, *a.truth.clear_until);
    a.truth = b.truth = {};
    EXPECT_EQ(to_json(a), to_json(b));
  }
}

TEST(Prove, ProvingAgainChangesNothing) {
  const ScratchFolder folder;
  for (const char* kind : {"RP", "RN"}) {
    const std::string set = generated(folder, "VE", kind, 4);
    const std::string first = folder / "first.jsonl", second = folder / "second.jsonl";
    succeeded(ccdfuzz({"prove", set, "-o", first, "--threads", "1"}));
    succeeded(ccdfuzz({"prove", first, "-o", second, "--threads", "3"}));
    EXPECT_EQ(read_text(first), read_text(second));
    if (std::filesystem::exists(trees_path(first))) {
      EXPECT_EQ(read_text(trees_path(first)), read_text(trees_path(second)));
    }
    // In place, too.
    succeeded(ccdfuzz({"prove", first, "-o", first}));
    EXPECT_EQ(read_text(first), read_text(second));
    succeeded(ccdfuzz({"verify", first}));
  }
}

TEST(Prove, WritesWhatIsUndecidedAsSuch) {
  const ScratchFolder folder;
  const std::string set = bare(folder, generated(folder, "FF", "RN", 1)), out = folder / "out.json";
  const Finished proven =
      succeeded(ccdfuzz({"prove", set, "-o", out, "--max-pops", "2", "--max-nodes", "2"}));
  EXPECT_NE(proven.out.find("1 case: 0 hits, 0 misses, 1 undecided\n"), std::string::npos);
  EXPECT_EQ(cases_of(out).at(0).value.truth.collides, std::nullopt);
}

TEST(Prove, AFalseClaimIsReplacedAndExits1) {
  const ScratchFolder folder;
  Case wrong = cases_of(generated(folder, "VV", "RN", 1)).at(0).value;
  wrong.query.t_max = 1.5;  // past the contact at t = 1
  wrong.truth.clear_until.reset();
  const std::string in = folder / "wrong.json", out = folder / "out.json";
  write_text(in, to_json(wrong));
  const Finished proven = failed(ccdfuzz({"prove", in, "-o", out, "--json"}));
  EXPECT_EQ(json_lines(proven.out).at(0).at("refuted"), true);
  EXPECT_EQ(cases_of(out).at(0).value.truth.collides, true);
  succeeded(ccdfuzz({"verify", out}));
}

/// What becomes of a proven set when its trees are not what they were.
class DamagedTrees : public testing::Test {
 protected:
  DamagedTrees() {
    // Without their planes, cases need trees.
    succeeded(ccdfuzz({"prove", bare(folder, generated(folder, "EF", "RN", 3)), "-o", set}));
  }
  void expect_refuted(const std::string& why) const {
    const Finished verified = failed(ccdfuzz({"verify", set, "--json"}));
    const auto rows = json_lines(verified.out);
    ASSERT_EQ(rows.size(), 3U);
    EXPECT_EQ(rows.back().at("truth"), "refuted");
    EXPECT_NE(rows.back().at("note").get<std::string>().find(why), std::string::npos)
        << rows.back();
  }

  const ScratchFolder folder;
  const std::string set = folder / "set.jsonl", trees = folder / "set.trees.zst";
};

TEST_F(DamagedTrees, Missing) {
  std::filesystem::remove(trees);
  expect_refuted("cannot read");
}

TEST_F(DamagedTrees, AreRefusedWhenTheyAreOfAnotherCase) {
  auto cases = cases_of(set);
  // The hash is right, but the tree is that of the case before.
  cases[2].value.truth.clearance = cases[1].value.truth.clearance;
  std::string text;
  for (const NamedCase& c : cases) text += to_json(c.value) + "\n";
  write_text(set, text);
  expect_refuted("truth.certificate.clear");
}

}  // namespace
}  // namespace ccdfuzz
