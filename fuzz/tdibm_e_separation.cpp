// Lines that are hard to order: TDIBM-E separates only what is separated.
#include "fuzz/target.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return ccdfuzz::check_bytes("tdibm-e.separation", data, size);
}
