// The methods against each other and against themselves, on contacts and near-misses.
#include "fuzz/target.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return ccdfuzz::check_target("methods", {data, size});
}
