// The judge, who is told wrong answers and right ones.
#include "fuzz/target.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return ccdfuzz::check_target("judge", {data, size});
}
