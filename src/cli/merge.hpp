#pragma once

#include <string>
#include <vector>

#include "numeric/result.hpp"

namespace ccdfuzz {

/// Puts data sets together: their cases, class by class and by index as generate makes them, their
/// miss trees and their generation records. Errors: a case that does not say what it is, stands out
/// of order, is there twice or is left out between two others; a missing share. Then nothing is
/// written.
Result<int> merge_data_sets(const std::vector<std::string>& inputs, const std::string& output);

}  // namespace ccdfuzz
