#include "ccd/tdibm.hpp"

#include <gtest/gtest.h>

#include "named_queries.hpp"

namespace ccdfuzz {
namespace {

SearchOptions coarse() {
  SearchOptions options;
  options.precision = 1e-2;
  return options;
}

TEST(TwinShield, PlainAndIntendedErrorBoundReportTheContact) {
  const Query query = twin_shield();
  Tdibm<Plain> plain;
  Tdibm<ErrorBoundIntended> error_bound;
  for (const Answer& answer :
       {plain.answer(query, coarse()), error_bound.answer(query, coarse())}) {
    EXPECT_EQ(answer.verdict, Verdict::kHit);
    EXPECT_NEAR(answer.toi.value_or(-1), .742, .001);
  }
}

TEST(TwinShield, PrintedSignMissesTheContact) {
  Tdibm<ErrorBoundPrinted> printed;
  EXPECT_EQ(printed.answer(twin_shield(), coarse()).verdict, Verdict::kMiss);
}

}  // namespace
}  // namespace ccdfuzz
