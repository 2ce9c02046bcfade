// Case files that ask for much, and whatever else stands in certificates: reader and checker end in
// little time and memory, which libFuzzer watches over (limits.options).
#include "fuzz/target.hpp"

const std::string_view ccdfuzz::kFuzzTarget = "limits";

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return ccdfuzz::check_input({data, size});
}
