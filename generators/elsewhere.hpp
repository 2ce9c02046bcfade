#pragma once

#include <functional>

#include "case/case.hpp"

namespace ccdfuzz {

/// A whole number from the first to the second, both included.
using Between = std::function<int(int, int)>;

/// The case in other coordinates, with the truth that similar() leaves it. By chance it is moved
/// and given a common velocity, each of up to 2^40 times the patches' size; its numbers are
/// multiplied by 2^-1000 to 2^900, and time by 2^-100 to 2^100. All is exact: what doubles have no
/// room for is left out. Where `between` gives 0 always, nothing changes.
Case elsewhere(const Case& base, const Between& between);

}  // namespace ccdfuzz
