#include "rows.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace ccdfuzz {
namespace {

const std::vector<PlantedFault> kThreeFaults = {{"a", "what", "a.hpp", false, "x", "y", ""},
                                                {"b", "what", "a.hpp", false, "x", "y", ""},
                                                {"c", "what", "a.hpp", false, "x", "y", ""}};

/// A run by the hunt, which noticed the fault after this many seconds, or did not within them.
struct Run {
  bool detected;
  double seconds;
};

void add_runs(Records& records, const char* fault, const std::vector<Run>& runs) {
  for (std::size_t i = 0; i < runs.size(); ++i) {
    Record r;
    r.driver = Driver::kHunt, r.fault = fault, r.seed = i + 1, r.detected = runs[i].detected;
    r.limit = r.detected ? 100 : runs[i].seconds;
    r.seconds = runs[i].seconds;
    r.executions = static_cast<std::uint64_t>(1000 * runs[i].seconds);
    ASSERT_TRUE(records.add(r));
  }
}

Row row_of_runs(const std::vector<Run>& runs) {
  auto records = Records::open("", kThreeFaults, Records::Use::kExtend);
  add_runs(*records, "a", runs);
  return rows_of(kThreeFaults, *records).at(0);
}

TEST(Rows, AMissTookLongerThanAllKillsHoweverSmallItsLimit) {
  const Row row = row_of_runs({{true, 1}, {false, 10}, {true, 45}, {true, 2}, {false, 10}});
  EXPECT_TRUE(row.is_kill());
  EXPECT_EQ(row.detected, 3);
  EXPECT_EQ(row.seconds, 45);
  EXPECT_EQ(row.executions, 45000);
}

TEST(Rows, HaveALowerBoundAsMedianWhenMostRunsMiss) {
  const Row row = row_of_runs({{true, 45}, {false, 10}, {false, 60}});
  EXPECT_FALSE(row.is_kill());
  EXPECT_EQ(row.seconds, 45);
  EXPECT_EQ(row_of_runs({{false, 10}, {false, 60}, {false, 10}}).seconds, 10);
}

TEST(Rows, CountAMissedFaultAsLongerThanAnyKilledOne) {
  auto records = Records::open("", kThreeFaults, Records::Use::kExtend);
  add_runs(*records, "a", {{true, 45}});
  add_runs(*records, "b", {{false, 10}});
  add_runs(*records, "c", {{true, 3}});
  const std::vector<DriverRow> killed = driver_rows(rows_of(kThreeFaults, *records));
  ASSERT_EQ(killed.size(), 1);
  EXPECT_FALSE(killed[0].censored);
  EXPECT_EQ(killed[0].seconds, 45);
  add_runs(*records, "c", {{false, 60}});
  const std::vector<DriverRow> missed = driver_rows(rows_of(kThreeFaults, *records));
  EXPECT_TRUE(missed[0].censored);
  EXPECT_EQ(missed[0].seconds, 45);
}

}  // namespace
}  // namespace ccdfuzz
