// The judge, who is told wrong answers and right ones.
#include "fuzz/target.hpp"

const std::string_view ccdfuzz::kFuzzTarget = "judge";

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return ccdfuzz::check_input({data, size});
}
