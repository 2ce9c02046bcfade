// The bytes are what a plug-in answers.
#include "fuzz/target.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return ccdfuzz::check_target("plugin_lines", {data, size});
}
