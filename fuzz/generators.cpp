// The generators: what they make is what it says.
#include "fuzz/target.hpp"

const std::string_view ccdfuzz::kFuzzTarget = "generators";

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return ccdfuzz::check_input({data, size});
}
