// Two patches in contact: exact TDIBM says so in time.
#include "fuzz/target.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return ccdfuzz::check_target("tdibm_rational", {data, size});
}
