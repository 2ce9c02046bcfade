// Certificates that are wrong, as bytes and in case files: the checker refuses each.
#include "fuzz/target.hpp"

const std::string_view ccdfuzz::kFuzzTarget = "certificates";

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return ccdfuzz::check_input({data, size});
}
