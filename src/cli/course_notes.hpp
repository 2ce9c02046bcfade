#pragma once

#include <string>
#include <utility>
#include <vector>

#include "hunt/hunt.hpp"
#include "report/report.hpp"

namespace ccdfuzz {

/// Samples how a hunt goes, at every 1/200 of it and at its end. By cases all but the seconds
/// repeats exactly.
class CourseNotes {
 public:
  explicit CourseNotes(std::vector<std::string> methods) : course_{std::move(methods), {}} {}

  void note(double seconds, const HuntProgress& progress) {
    if (progress.share < next_ && progress.share < 1) return;
    course_.samples.push_back(
        {seconds, progress.queries, progress.mutants, progress.finds, progress.margins});
    next_ = progress.share + 1.0 / 200;
  }
  const HuntCourse& course() const { return course_; }

 private:
  HuntCourse course_;
  double next_ = 0;
};

}  // namespace ccdfuzz
