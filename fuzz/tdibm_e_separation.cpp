// Lines that are hard to order: TDIBM-E separates only what is separated, in each of its steps.
#include "fuzz/target.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return ccdfuzz::check_target("tdibm_e_separation", {data, size});
}
