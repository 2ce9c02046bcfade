// Lines that are hard to order: the envelope of TDIBM-E bounds them from above.
#include "fuzz/target.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return ccdfuzz::check_bytes("tdibm-e.envelope", data, size);
}
