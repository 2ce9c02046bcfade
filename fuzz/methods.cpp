// The methods against each other and against themselves, on contacts and near-misses.
#include "fuzz/target.hpp"

const std::string_view ccdfuzz::kFuzzTarget = "methods";

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return ccdfuzz::check_input({data, size});
}
