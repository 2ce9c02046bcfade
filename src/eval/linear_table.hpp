#pragma once

#include <atomic>
#include <functional>
#include <string>
#include <vector>

#include "base/table.hpp"
#include "eval/imported.hpp"
#include "eval/rows.hpp"
#include "method/method.hpp"

namespace ccdfuzz {

/// The linear queries of a folder.
struct LinearFile {
  std::string path;
  CsvLayout layout = CsvLayout::kEdgeEdge;
};

/// All .csv files under a folder whose path tells that they are edge-edge or vertex-face, by name.
/// Errors: there is none, or no such folder.
Result<std::vector<LinearFile>> linear_files(const std::string& folder);

/// What was found out besides.
struct LinearReport {
  std::vector<Row> rows;          ///< the class is that of the queries: "edge-edge" first
  std::vector<Imported> notable;  ///< wrong labels, and truths that rounding changed
  std::uint64_t queries = 0, labels = 0, rounded_values = 0, rounded_queries = 0;
};

/// Puts every query to every method. Each is asked, and judged by its own exact truth, with its
/// numbers rounded to doubles where they are none, which is counted. Times are CPU time (of
/// plug-ins what they say they took), the least of three answers, of one that took longer than 10
/// ms. stop ends it early.
Result<LinearReport> evaluate_linear(
    const std::vector<LinearFile>& files, const std::vector<std::string>& methods,
    const SearchOptions& search, int threads,
    const std::function<void(double share, std::uint64_t queries)>& progress,
    const std::atomic<bool>* stop = nullptr);

/// The shape of the paper's Table 3, with its numbers beside where it has them.
Table linear_table(const std::vector<Row>& rows);

}  // namespace ccdfuzz
