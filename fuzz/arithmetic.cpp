// Any two doubles, as exact numbers and back.
#include "fuzz/target.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return ccdfuzz::check_bytes("dyadic.round_trip", data, size);
}
