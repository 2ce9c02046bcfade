#pragma once

#include <string>
#include <vector>

#include "hunt/hunt.hpp"
#include "report/report.hpp"

namespace ccdfuzz {

/// Notes how a hunt goes, at most so often that a page has room for it, and how it ended: by time
/// every so many seconds, by cases every so large a share of it, so that all but the seconds
/// repeats exactly.
class CourseNotes {
 public:
  CourseNotes(std::vector<std::string> methods, bool by_cases);

  /// Of a share of 1 every note is kept: the hunt is over.
  void note(double seconds, const HuntProgress& progress);
  const HuntCourse& course() const { return course_; }

 private:
  HuntCourse course_;
  bool by_cases_;
  double step_;  ///< seconds, or share of the hunt
  double next_ = 0;
};

}  // namespace ccdfuzz
