// Lines that are hard to order: the envelope of TDIBM-E bounds them from above, and so does each
// bound that it rests on.
#include "fuzz/target.hpp"

const std::string_view ccdfuzz::kFuzzTarget = "tdibm_e_envelope";

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return ccdfuzz::check_input({data, size});
}
