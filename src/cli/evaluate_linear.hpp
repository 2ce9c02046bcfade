#pragma once

#include "eval/evaluate.hpp"

namespace ccdfuzz {

/// `evaluate --linear folder`: the table, wrong labels, and what rounding changed. page: a folder
/// for an HTML page of them, or empty.
Result<int> run_evaluate_linear(const std::string& folder, const EvaluateOptions& options,
                                bool json, const std::string& page);

}  // namespace ccdfuzz
