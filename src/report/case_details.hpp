#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "report/report.hpp"

namespace ccdfuzz {

/// The value as one line of JSON, without its end. Bytes that are not UTF-8, as file names may
/// have them, become U+FFFD: whatever they are is shown, not refused.
std::string json_text(const nlohmann::ordered_json& value);

/// One case on the page: a short row for lists, and the details that its viewer reads
/// when the case is opened.
struct CaseText {
  nlohmann::ordered_json row;
  std::string details;  ///< JSON
};

/// Traces the witness of the case, if it has one within t_max, through every method that failed on
/// it. With trace_all, or if none failed, through all that were asked. Plug-ins are not traced.
/// The row: [id, class, kind, generator, outcomes, new, worst, setting, bits, causes]:
/// - `outcomes` has a letter for each method ("-" where it was not asked);
/// - `worst` is the first loss of a failed method, [method, level, axis, ulps or null], or null;
/// - `bits` are the query's significant bits (CaseSize);
/// - `causes` maps methods that failed to the cause: the one that the case expects, or the trace's.
CaseText describe(const ReportedCase& reported, const std::vector<std::string>& methods,
                  bool trace_all);

}  // namespace ccdfuzz
