#pragma once

#include <vector>

#include "cli/hunt_record.hpp"
#include "hunt/hunt.hpp"

namespace ccdfuzz {

/// Notes how a hunt goes, at most so often that a page has room for it: by time every so many
/// seconds, by cases every so many of its steps, so that all but the seconds repeats exactly.
class CourseNotes {
 public:
  CourseNotes(std::vector<std::string> methods, bool by_cases)
      : course_{std::move(methods), {}}, by_cases_(by_cases), step_(by_cases ? 1 : 0.25) {}

  void note(double seconds, const HuntProgress& progress);
  const HuntCourse& course() const { return course_; }

 private:
  HuntCourse course_;
  bool by_cases_;
  std::uint64_t steps_ = 0;
  double step_;  ///< seconds, or steps of the hunt
  double next_ = 0;
};

/// What a hunt's page shows: its cells, its course, what it found, and what its store held before.
/// Errors: the store cannot be read.
Result<ReportPage> hunt_page(const HuntRecord& record);

}  // namespace ccdfuzz
