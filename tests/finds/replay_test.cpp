#include "finds/replay.hpp"

#include <gtest/gtest.h>

#include "case/case_json.hpp"
#include "certify/checker/check_case.hpp"
#include "finds/finds.hpp"
#include "scratch_folder.hpp"

namespace ccdfuzz {
namespace {

/// "miss" always misses, "hit" always hits at 0; there is no other method.
Result<Judged> answer(const std::string& method, const NamedCase& entry) {
  Answer a;
  a.verdict = Verdict::kMiss;
  if (method == "hit") {
    a.verdict = Verdict::kHit;
    a.toi = 0;
  } else if (method != "miss") {
    return input_error("", "unknown method \"" + method + "\"");
  }
  return Judged{a, judge(checked_or_unknown(entry.value), a), ""};
}

TEST(Replay, ReportsWhatChangedAndWhatDidNot) {
  Case c = find_of(1, "miss", Outcome::kMissed);
  c.expect["hit"] = Outcome::kLate;
  Case silent = find_of(1);
  silent.expect.clear();
  const auto report = replay({{"a.json", c}, {"b.json", silent}}, answer);
  ASSERT_TRUE(report) << report.error().message();
  EXPECT_EQ(report->entries, 2U);
  EXPECT_EQ(report->without_expectation, 1U);
  ASSERT_EQ(report->rows.size(), 2U);
  EXPECT_EQ(to_text(report->rows[0]), "a.json: hit: expected late, got correct");
  EXPECT_TRUE(report->rows[0].changed());
  EXPECT_EQ(report->rows[1].got.outcome, Outcome::kMissed);
  EXPECT_FALSE(report->rows[1].changed());
  EXPECT_EQ(report->changed(), 1U);
}

TEST(Replay, AMethodThatThereIsNotIsAnErrorNamingTheEntry) {
  const auto report = replay({{"a.json", find_of(1, "gone")}}, answer);
  ASSERT_FALSE(report);
  EXPECT_EQ(report.error().message(), "a.json: expect[\"gone\"]: unknown method \"gone\"");
}

TEST(Replay, AnEmptyCorpusIsAnError) {
  EXPECT_FALSE(replay(std::vector<NamedCase>{}, answer));
  const ScratchFolder folder;
  const auto report = replay(folder.path(), answer);
  ASSERT_FALSE(report);
  EXPECT_EQ(report.error().message(),
            folder.path() + ": the corpus is empty: no .json entry in it");
}

TEST(Replay, ReadsACorpusWithItsSubfolders) {
  const ScratchFolder folder;
  std::filesystem::create_directories(folder / "regressions/deep");
  write_text(folder / "regressions/deep/a.json", to_json(find_of(1, "miss")));
  write_text(folder / "b.json", to_json(find_of(2, "miss")));
  const auto report = replay(folder.path(), answer);
  ASSERT_TRUE(report) << report.error().message();
  EXPECT_EQ(report->rows.size(), 2U);
  EXPECT_EQ(report->changed(), 0U);
}

}  // namespace
}  // namespace ccdfuzz
