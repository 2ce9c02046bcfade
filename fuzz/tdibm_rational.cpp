// Two patches in contact: exact TDIBM says so in time.
#include <array>

#include "fuzz/target.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static constexpr auto kClaims = std::to_array<std::string_view>({
      "tdibm-rational.no_false_negative",
      "tdibm-rational.no_false_negative_fine",
      "tdibm-rational.no_false_negative_linear",
      "tdibm-rational.trace",
      "tdibm-rational.error_bound",
  });
  return ccdfuzz::check_bytes_of_any(kClaims, data, size);
}
