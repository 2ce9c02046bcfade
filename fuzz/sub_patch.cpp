// Any shape, control points on a lattice, any cell: subdivision is exact.
#include "fuzz/target.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return ccdfuzz::check_bytes("sub_patch.is_the_restriction", data, size);
}
