// The bytes are a case file. Seeds: the corpus.
#include "fuzz/target.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return ccdfuzz::check_target("case_reader", {data, size});
}
