// The bytes are a case file. Seeds: the corpus.
#include "fuzz/target.hpp"

const std::string_view ccdfuzz::kFuzzTarget = "case_reader";

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return ccdfuzz::check_input({data, size});
}
