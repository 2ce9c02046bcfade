// Any shape, control points on a lattice, any cell: subdivision is exact, and nothing is outside of
// what bounds it.
#include "fuzz/target.hpp"

const std::string_view ccdfuzz::kFuzzTarget = "sub_patch";

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return ccdfuzz::check_input({data, size});
}
