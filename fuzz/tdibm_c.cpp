// Two patches in contact, tiny ones too: certified TDIBM says so in time, however they are moved,
// written or cut, and drops no box with the contact on the way.
#include "fuzz/target.hpp"

const std::string_view ccdfuzz::kFuzzTarget = "tdibm_c";

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return ccdfuzz::check_input({data, size});
}
