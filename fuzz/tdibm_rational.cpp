// Two patches in contact: exact TDIBM says so in time.
#include "fuzz/target.hpp"

const std::string_view ccdfuzz::kFuzzTarget = "tdibm_rational";

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return ccdfuzz::check_input({data, size});
}
