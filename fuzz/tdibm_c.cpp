// Two tiny patches in contact: certified TDIBM says so in time.
#include "fuzz/target.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return ccdfuzz::check_bytes("tdibm-c.no_false_negative_underflow", data, size);
}
