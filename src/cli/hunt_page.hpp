#pragma once

#include <string>
#include <utility>
#include <vector>

#include "eval/columns.hpp"
#include "files/case_files.hpp"
#include "hunt/hunt.hpp"
#include "method/by_spec.hpp"
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

/// The record that a hunt leaves beside its page, so that `ccdfuzz report` can make the page again.
struct HuntRecord {
  std::string command;     ///< that hunted
  std::string store;       ///< folder of the counterexamples, as the command line gave it
  std::string store_from;  ///< the way to it from the folder of the record; empty: there is none
  double seconds = 0;
  std::vector<HuntCell> cells;
  std::vector<std::string> finds;  ///< paths of the new counterexamples
  HuntCourse course;
  std::vector<MethodInfo> plugins;  ///< among the methods

  static void fields(auto& archive, auto& record) {
    archive.format("ccdfuzz-hunt", 2, 2);
    archive("command", record.command);
    archive("store", record.store);
    archive.optional("store_from_here", record.store_from);
    archive("seconds", record.seconds, not_negative);
    archive("cells", record.cells);
    archive("finds", record.finds);
    archive("course", record.course);
    archive("plugins", record.plugins);
  }
};

/// FOLDER/hunt.jsonl: the record as one line. Not .json, so that a folder that is a corpus, too,
/// has no entry more.
std::string hunt_record_path(const std::string& folder);

/// Makes the folder if need be. Errors: of the system, naming the path.
Result<void> write_hunt_record(const std::string& folder, HuntRecord record);

/// Runs no method, and needs none that it names. A store that has been moved along with the record
/// is found beside it. Errors: naming file, field and value.
Result<HuntRecord> read_hunt_record(const std::string& folder);

/// The mean time of an answer.
Column<HuntCell> mean_column();

/// False for plug-ins and bodies, which are not traced: none of their mutants is known to be lost.
bool any_is_traced(const std::vector<HuntCell>& cells);

/// How many mutants each method was asked, and how many of them its tests lost, if any is traced.
void add_mutant_columns(std::vector<Column<HuntCell>>& columns, const std::vector<HuntCell>& cells);

/// The results of each method in each class.
Table hunt_table(const std::vector<HuntCell>& cells);

/// An entry as its expectations say. Where those are of a time that a method reported, a method
/// that may be started (is_admitted) is asked for it again.
Result<ReportedCase> reported_entry(NamedCase entry, MethodSet& methods);

/// The data of a hunt's page: its cells, its course, its finds, and the earlier ones of its store.
/// If the store is not there, only that, which stderr says, too. Errors: the store cannot be read.
Result<ReportPage> hunt_page(const HuntRecord& record);

}  // namespace ccdfuzz
