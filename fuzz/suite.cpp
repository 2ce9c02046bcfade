// The libFuzzer target of the claims of one suite, which the build names.
#include "fuzz/target.hpp"

const std::string_view ccdfuzz::kSuite = CCDFUZZ_SUITE;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return ccdfuzz::check_input({data, size});
}
