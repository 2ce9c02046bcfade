#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "eval/generation_cost.hpp"
#include "files/case_files.hpp"
#include "report/report.hpp"

namespace ccdfuzz {

/// Keeps what a page shows of an evaluation beside its rows: cases and their curvatures.
class ReportRows {
 public:
  /// precision: that the case was asked at.
  void add(const EvaluatedCase& evaluated, const Case& known, double precision);

  /// Adds the rows, by class, kind, horizon and method, and all cases with a failure, as far as
  /// there is room. If there is none, some cases of each class and kind. rows: of the same answers.
  /// costs: of making the cases, if known.
  void finish(ReportPage& report, const Rows& rows, const std::vector<GenerationCost>& costs);

 private:
  void keep(ReportedCase reported, const Case& known, const std::optional<double>& factor);
  void add_curvatures(const Case& known);

  std::vector<ReportedCase> failed_, samples_;
  std::map<std::string, int> sampled_;
  LogHistogram curvatures_;
};

}  // namespace ccdfuzz
