// Lines that are hard to order: TDIBM-E separates only what is separated, in each of its steps.
#include "fuzz/target.hpp"

const std::string_view ccdfuzz::kFuzzTarget = "tdibm_e_separation";

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return ccdfuzz::check_input({data, size});
}
