#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "case/case.hpp"
#include "eval/rows.hpp"
#include "hunt/hunt.hpp"
#include "io/table.hpp"

namespace ccdfuzz {

/// A table, shown as it is.
struct ReportTable {
  std::string id;     ///< unique in its page: what its CSV is called
  std::string title;  ///< one line
  Table table;
  std::string note = {};  ///< below the title
};

/// A case that the page shows in its viewer.
struct ReportedCase {
  std::string id;  ///< where it is
  Case value = {};
  std::vector<GivenAnswer> answers;  ///< of each its method, outcome and toi
  double precision = 1e-4;           ///< that it was asked at
  std::optional<bool> is_new = {};   ///< for a hunt: found now, or known before
  std::string reproduce = {};        ///< the command that shows it again; may be empty

  bool has_failure() const {
    return std::ranges::any_of(answers, is_failure, &GivenAnswer::outcome);
  }
};

/// Everything that a page shows. Parts that are empty have no tab in it.
struct ReportPage {
  std::string title;
  std::string command;  ///< that made it
  std::vector<ReportTable> tables;
  std::vector<Row> rows;            ///< what figures are made of; untimed where nothing was timed
  std::vector<std::string> hunted;  ///< the methods of a hunt
  std::vector<HuntSample> course;   ///< how it went, in order
  std::string scoreboard;           ///< the JSON that `ccdfuzz-scoreboard --tables` wrote, or empty
  /// The curvatures of both patches of the positive cases at their contacts, as rms_curvature.
  LogHistogram curvatures;
  std::vector<ReportedCase> cases;
  std::uint64_t cases_left_out = 0;  ///< failures that the page has no room for
};

/// The limits of a page, so that it stays small and quick to open.
inline constexpr std::size_t kMostReportedCases = 5000;
inline constexpr std::size_t kMostPageBytes = 19'000'000;

/// Keeps at most `most` of the cases, the first ones. Each class, kind and set of failing methods
/// has the same number where there are enough. Counts the rest in cases_left_out.
void keep_most_telling(ReportPage& report, std::size_t most = kMostReportedCases);

/// The page as one HTML text that needs no network: the viewer, and the report as data in it.
/// Witnesses are traced on `threads` threads.
std::string report_page(const ReportPage& report, int threads);

/// Writes folder/index.html atomically. A page of more than most_bytes is made of fewer cases
/// (keep_most_telling). Makes the folder if need be. Errors: of the system, naming the path.
Result<void> write_report(ReportPage report, const std::string& folder, int threads,
                          std::size_t most_bytes = kMostPageBytes);

}  // namespace ccdfuzz
