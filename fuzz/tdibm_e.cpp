// Two patches in contact: TDIBM-E says so in time where nothing underflows, wherever they lie, and
// drops no box with the contact on the way.
#include "fuzz/target.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return ccdfuzz::check_target("tdibm_e", {data, size});
}
