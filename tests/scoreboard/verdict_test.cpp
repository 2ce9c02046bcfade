#include "verdict.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace ccdfuzz {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

const std::vector<PlantedFault> kTwoFaults = {
    {"some", "what", "a.hpp", false, "x", "y", ""},
    {"same", "what", "a.hpp", false, "x", "z", "it is equal"}};

/// What is said of one run.
std::vector<std::string> said_of(Driver driver, const char* fault, bool detected) {
  auto records = Records::open("", kTwoFaults, Records::Use::kExtend);
  Record r;
  r.driver = driver, r.fault = fault, r.seed = 3, r.limit = 2.5, r.detected = detected;
  r.found = "x is wrong";
  EXPECT_TRUE(records->add(r));
  return complaints(kTwoFaults, *records);
}

TEST(Verdict, IsSilentWhereAllIsAsItShouldBe) {
  EXPECT_THAT(said_of(Driver::kHunt, "none", false), IsEmpty());
  EXPECT_THAT(said_of(Driver::kHunt, "watched", false), IsEmpty());
  EXPECT_THAT(said_of(Driver::kHunt, "some", true), IsEmpty());
  EXPECT_THAT(said_of(Driver::kHunt, "same", false), IsEmpty());
  EXPECT_THAT(said_of(Driver::kRandom, "some", false), IsEmpty());
}

TEST(Verdict, NamesFalseAlarmsAndTheirRuns) {
  EXPECT_THAT(said_of(Driver::kHunt, "none", true),
              ElementsAre("false alarm: hunt seed 3: x is wrong\n  again: ccdfuzz-scoreboard "
                          "--drivers hunt --faults none --only-seed 3 --seconds 5 "
                          "--weak-seconds 5"));
  EXPECT_THAT(said_of(Driver::kRandom, "watched", true),
              ElementsAre("false alarm: random seed 3, all faults watched: x is wrong\n  again: "
                          "ccdfuzz-scoreboard --drivers random --faults watched --only-seed 3 "
                          "--seconds 5 --weak-seconds 5"));
}

TEST(Verdict, NamesEquivalentFaultsThatWereNoticed) {
  EXPECT_THAT(said_of(Driver::kRandom, "same", true),
              ElementsAre("equivalent, but noticed: same by random seed 3: x is wrong\n  again: "
                          "ccdfuzz-scoreboard --drivers random --faults same --only-seed 3 "
                          "--seconds 5 --weak-seconds 5"));
}

TEST(Verdict, NamesFaultsThatNobodyNoticed) {
  EXPECT_THAT(said_of(Driver::kProperties, "some", false),
              ElementsAre("not noticed: some\n  again: ccdfuzz-scoreboard --drivers "
                          "properties,hunt --faults some"));
}

TEST(Verdict, IsGoodOnTheStoredRecords) {
  const std::string folder = CCDFUZZ_SOURCE_DIR "/bench/scoreboard/";
  const auto faults = read_faults(folder + "faults.txt");
  ASSERT_TRUE(faults) << faults.error().message();
  const auto records = Records::open(folder + "records.jsonl", *faults, Records::Use::kRead);
  ASSERT_TRUE(records) << records.error().message();
  EXPECT_FALSE(records->all().empty());
  EXPECT_THAT(complaints(*faults, *records), IsEmpty());
}

}  // namespace
}  // namespace ccdfuzz
