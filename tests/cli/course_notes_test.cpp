#include "cli/hunt_page.hpp"

#include <gtest/gtest.h>

namespace ccdfuzz {
namespace {

HuntProgress progress(double share, std::uint64_t queries, std::uint64_t mutants) {
  return {share, queries, mutants, queries / 10, {queries, std::nullopt}};
}

/// As many samples as a page has room for, in order, each complete.
void expect_course(const HuntCourse& course) {
  EXPECT_LE(course.samples.size(), 400U);
  double before = -1;
  for (const HuntSample& sample : course.samples) {
    EXPECT_GT(sample.seconds, before);
    before = sample.seconds;
    ASSERT_EQ(sample.margins.size(), 2U) << sample.seconds;
    EXPECT_EQ(sample.margins[0], sample.queries) << sample.seconds;
  }
}

TEST(CourseNotes, KeepAFewHundredCompleteSamplesOfALongHunt) {
  constexpr int kSeconds = 1000;
  CourseNotes notes({"a", "b"});
  for (int i = 0; i <= 10 * kSeconds; ++i) {
    const auto at = static_cast<std::uint64_t>(i);
    notes.note(i / 10.0, progress(i / (10.0 * kSeconds), at, at));
  }
  expect_course(notes.course());
  const std::vector<HuntSample>& samples = notes.course().samples;
  EXPECT_GE(samples.size(), 200U);
  EXPECT_EQ(samples.front().seconds, 0);
  EXPECT_EQ(samples.back().seconds, kSeconds) << "how it ended";
}

TEST(CourseNotes, ShowBreedingAndEndOfAHuntByCases) {
  constexpr std::uint64_t kDraws = 5000, kPopulations = 12;
  CourseNotes notes({"a", "b"});
  double seconds = 0;
  for (std::uint64_t i = 1; i <= kDraws; ++i) {
    notes.note(seconds += 0.01, progress(0.5 * static_cast<double>(i) / kDraws, i, 0));
  }
  for (std::uint64_t i = 1; i <= kPopulations; ++i) {
    notes.note(seconds += 1,
               progress(0.5 + 0.5 * static_cast<double>(i) / kPopulations, kDraws, 1000 * i));
  }
  notes.note(seconds += 5, progress(1, kDraws + 1, 1000 * kPopulations));
  expect_course(notes.course());
  const std::vector<HuntSample>& samples = notes.course().samples;
  EXPECT_GE(samples.size(), 100 + kPopulations);
  EXPECT_EQ(samples[samples.size() - kPopulations - 1].mutants, 1000U) << "one for each population";
  EXPECT_EQ(samples.back().queries, kDraws + 1) << "how it ended";
}

}  // namespace
}  // namespace ccdfuzz
