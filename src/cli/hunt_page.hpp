#pragma once

#include <vector>

#include "files/case_files.hpp"
#include "hunt/hunt.hpp"
#include "io/table.hpp"
#include "method/by_spec.hpp"
#include "report/report.hpp"

namespace ccdfuzz {

/// Samples how a hunt goes, at every 1/200 of it and at its end. By cases all but the seconds
/// repeats exactly.
class CourseNotes {
 public:
  explicit CourseNotes(const std::vector<std::string>& methods) : course_{methods, {}} {}

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

/// False for plug-ins and bodies, which are not traced: none of their mutants is known to be lost.
bool any_is_traced(const std::vector<HuntCell>& cells);

/// The results of each method.
Table method_table(const std::vector<HuntCell>& cells);

/// The results of each method in each class.
Table hunt_table(const std::vector<HuntCell>& cells);

/// An entry as its expectations say. Where those are of a time that a method reported, a method
/// that may be started (is_admitted) is asked for it again. Errors: its truth is refuted; a method
/// that there is not.
Result<ReportedCase> reported_entry(const NamedCase& entry, MethodSet& methods);

/// The data of a hunt's page: its cells, its course, its finds, and the earlier ones of its store.
/// Errors: the store cannot be read.
Result<ReportPage> hunt_page(const HuntReport& hunted, const HuntCourse& course,
                             const Store& store);

}  // namespace ccdfuzz
