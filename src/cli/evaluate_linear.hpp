#pragma once

#include "eval/evaluate.hpp"

namespace ccdfuzz {

/// `evaluate --linear folder`: the table, wrong labels, and what rounding changed.
Result<int> run_evaluate_linear(const std::string& folder, const EvaluateOptions& options,
                                bool json);

}  // namespace ccdfuzz
