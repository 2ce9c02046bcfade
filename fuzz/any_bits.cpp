// Every method's library interface on queries and options of any bits: counts that do not fit, NaN,
// degrees and kinds that there are not.
#include "fuzz/target.hpp"

const std::string_view ccdfuzz::kFuzzTarget = "any_bits";

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return ccdfuzz::check_input({data, size});
}
