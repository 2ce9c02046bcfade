// The bytes are a query CSV, as public sets of queries are.
#include "fuzz/target.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return ccdfuzz::check_target("query_csv", {data, size});
}
