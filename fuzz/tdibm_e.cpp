// Two patches in contact: TDIBM-E says so in time, where nothing underflows.
#include "fuzz/target.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return ccdfuzz::check_bytes("tdibm-e.no_false_negative", data, size);
}
