// Two patches in contact: TDIBM-E says so in time where nothing underflows, wherever they lie, and
// drops no box with the contact on the way.
#include "fuzz/target.hpp"

const std::string_view ccdfuzz::kFuzzTarget = "tdibm_e";

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return ccdfuzz::check_input({data, size});
}
