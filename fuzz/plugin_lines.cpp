// The bytes are what a plug-in answers.
#include "fuzz/target.hpp"

const std::string_view ccdfuzz::kFuzzTarget = "plugin_lines";

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return ccdfuzz::check_input({data, size});
}
