// The bytes are a query CSV, as public sets of queries are.
#include "fuzz/target.hpp"

const std::string_view ccdfuzz::kFuzzTarget = "query_csv";

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return ccdfuzz::check_input({data, size});
}
