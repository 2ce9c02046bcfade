#pragma once

#include <string>
#include <vector>

#include "base/result.hpp"

namespace ccdfuzz {

/// Puts data sets together: their cases, class by class and by index as generate makes them, their
/// miss trees and their generation records. Errors: a case that does not say what it is, stands out
/// of order, is there twice or is left out between two others; a missing share. Then nothing is
/// written.
Result<int> merge_data_sets(const std::vector<std::string>& inputs, const std::string& output);

/// Puts the folders of shares of one evaluation together. Errors: they are not the shares of one,
/// each once.
Result<int> merge_evaluations(const std::vector<std::string>& inputs, const std::string& output);

/// Adds the entries of corpora to the corpus `output`: of each failure the smallest stays, as if
/// one hunt had found them all.
Result<int> merge_corpora(const std::vector<std::string>& inputs, const std::string& output);

}  // namespace ccdfuzz
