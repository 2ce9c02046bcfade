// Linear queries, degenerate above all: two exact codes that share nothing agree.
#include "fuzz/target.hpp"

const std::string_view ccdfuzz::kFuzzTarget = "linear";

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return ccdfuzz::check_input({data, size});
}
