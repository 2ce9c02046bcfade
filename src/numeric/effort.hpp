#pragma once

#include <cstdint>

#include "base/result.hpp"

namespace ccdfuzz {

/// CCDFUZZ_EFFORT of the environment, a whole factor on the number of random inputs; 1 if it is
/// unset or empty. Errors: anything but a whole number from 1 to 1000000.
Result<std::uint64_t> effort();

}  // namespace ccdfuzz
