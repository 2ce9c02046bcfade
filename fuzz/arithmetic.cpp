// Numbers of every kind that is exact, or says how far it is not, against GMP.
#include "fuzz/target.hpp"

const std::string_view ccdfuzz::kFuzzTarget = "arithmetic";

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return ccdfuzz::check_input({data, size});
}
