// The libFuzzer target of the claims of one suite, which the build names.
#include "fuzz/target.hpp"

const std::string_view ccdfuzz::kSuite = CCDFUZZ_SUITE;
