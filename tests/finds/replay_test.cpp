#include "finds/replay.hpp"

#include <gtest/gtest.h>

#include "certify/checker/check_case.hpp"
#include "finds/finds.hpp"

namespace ccdfuzz {
namespace {

TEST(Change, IsARegressionIffItIsWorse) {
  const Expected correct = Outcome::kCorrect, undecided = Outcome::kUndecided,
                 missed = {Outcome::kMissed, "left root"};
  EXPECT_EQ(change_of(correct, correct), Change::kNone);
  EXPECT_EQ(change_of(correct, missed), Change::kRegression);
  EXPECT_EQ(change_of(correct, undecided), Change::kRegression);
  EXPECT_EQ(change_of(undecided, missed), Change::kRegression);
  EXPECT_EQ(change_of(missed, correct), Change::kImprovement);
  EXPECT_EQ(change_of(missed, undecided), Change::kImprovement);
  EXPECT_EQ(change_of(missed, Outcome::kLate), Change::kOther);
  EXPECT_EQ(change_of(undecided, Outcome::kUnknown), Change::kOther);
}

TEST(Change, TellsCausesApartWhereTheEntrySaysOne) {
  EXPECT_EQ(change_of({Outcome::kMissed, "left root"}, {Outcome::kMissed, "hull"}), Change::kOther);
  EXPECT_EQ(change_of({Outcome::kError, "hang"}, {Outcome::kError, "crash SIGSEGV"}),
            Change::kOther);
  EXPECT_EQ(change_of(Outcome::kMissed, {Outcome::kMissed, "hull"}), Change::kNone);
}

TEST(Replayer, AsksEachMethodAndSaysWhatItSaysNow) {
  const CheckedCase known = checked_or_unknown(find_of(1));
  Replayer replayer;
  const auto rows = replayer.replay(
      "a.json", known, {{"tdibm", Outcome::kMissed}, {"tdibm-c", Outcome::kCorrect}}, {});
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[0].method, "tdibm");
  EXPECT_EQ(rows[0].got, Outcome::kCorrect);
  EXPECT_EQ(rows[0].change(), Change::kImprovement);
  EXPECT_EQ(rows[1].change(), Change::kNone);
}

}  // namespace
}  // namespace ccdfuzz
