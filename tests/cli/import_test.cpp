// import and export: query CSVs in and out of the real program.
#include <gmock/gmock.h>

#include "falling_vertex.hpp"
#include "files/case_files.hpp"
#include "process.hpp"

namespace ccdfuzz {
namespace {

using testing::HasSubstr;

TEST(Import, DecidesExactly) {
  const ScratchFolder folder;
  const std::string csv = folder / "vertex-face.csv", out = folder / "out.jsonl";
  write_text(csv, falling_vertex("-1,2", 1) + falling_vertex("1,2", 1) + falling_vertex("0,1", 1));
  const Finished done = succeeded(ccdfuzz({"import", csv, "-o", out}));
  EXPECT_THAT(done.out, HasSubstr("3 queries: 2 hits, 1 miss; 1 of 3 labels are wrong\n"));
  const Finished verified = ccdfuzz({"verify", out});
  EXPECT_EQ(verified.out, "3 cases: 3 hold, 0 refuted, 0 unproven\n");
  const auto cases = read_cases(out);
  ASSERT_TRUE(cases);
  EXPECT_EQ((*cases)[0].value.truth.witness->t, Rational(2, 3));
  EXPECT_EQ((*cases)[0].value.origin.more.at("label"), "1");
  EXPECT_EQ((*cases)[1].value.truth.proof, "L");
}

TEST(Import, TellsWhereRoundingChangesTheTruth) {
  const ScratchFolder folder;
  const std::string csv = folder / "vertex-face.csv", out = folder / "out.jsonl";
  // Ends above the face by less than the least double.
  const std::string denominator = to_text(Rational(3 * power_of_two(1100)));
  write_text(csv, falling_vertex("1," + denominator, 0));
  refused(ccdfuzz({"import", csv, "-o", out}), csv + ":5: z = 1/");
  EXPECT_FALSE(std::filesystem::exists(out));
  const Finished done = succeeded(ccdfuzz({"import", csv, "-o", out, "--round"}));
  EXPECT_THAT(done.out, HasSubstr("1 query: 1 hit, 0 misses; 0 of 1 labels are wrong; 1 values "
                                  "of 1 queries rounded, which changed the truth of 1\n"));
}

TEST(Export, WritesATestOfAnEngineForEachCaseIntoAFolder) {
  const ScratchFolder folder;
  const std::string csv = folder / "vertex-face.csv", cases = folder / "cases.jsonl";
  write_text(csv, falling_vertex("-1,2", 1) + falling_vertex("-1,4", 1));
  ASSERT_EQ(ccdfuzz({"import", csv, "-o", cases}).code, 0);
  const Finished done = ccdfuzz({"export", cases, "--as", "fcl", "-o", folder / "tests/"});
  EXPECT_EQ(done.out, "2 tests\n") << done.err;
  EXPECT_TRUE(std::filesystem::exists(folder / "tests/cases-1.cpp"));
  EXPECT_TRUE(std::filesystem::exists(folder / "tests/cases-2.cpp"));
  EXPECT_THAT(ccdfuzz({"export", cases, "--as", "fcl", "-o", folder / "one.cpp"}).err,
              HasSubstr("cases.jsonl:2: a file has one test"));
  EXPECT_THAT(ccdfuzz({"export", cases, cases, "--as", "fcl", "-o", folder / "tests/"}).err,
              HasSubstr("cases.jsonl:1: "));
}

TEST(Import, RefusesWhatItCannotRead) {
  const ScratchFolder folder;
  const std::string csv = folder / "queries.csv", out = folder / "out.jsonl";
  write_text(csv, falling_vertex("0,1", -1));
  EXPECT_THAT(ccdfuzz({"import", csv, "-o", out}).err, HasSubstr("does not tell its layout: "));
  succeeded(ccdfuzz({"import", csv, "-o", out, "--as", "vertex-face"}));
  EXPECT_EQ(ccdfuzz({"import", csv, "-o", out, "--as", "curved"}).code, 2);
  EXPECT_EQ(ccdfuzz({"import", csv, "-o", out, "--as", "faces"}).code, 2);
  EXPECT_EQ(ccdfuzz({"import", csv, csv, "-o", out, "--truths", csv}).code, 2);
}

TEST(Export, GivesBackWhatImportRead) {
  const ScratchFolder folder;
  const std::string csv = folder / "vertex-face.csv", cases = folder / "cases.jsonl",
                    back = folder / "back.csv";
  const std::string text = falling_vertex("-1,2", 1) + falling_vertex("1,2", 0);
  write_text(csv, text);
  succeeded(ccdfuzz({"import", csv, "-o", cases}));
  const Finished done = succeeded(ccdfuzz({"export", cases, "-o", back}));
  EXPECT_EQ(done.out, "2 vertex-face queries\n");
  EXPECT_EQ(read_text(back), text);
}

}  // namespace
}  // namespace ccdfuzz
