// Two patches in contact: TDIBM-E says so in time where nothing underflows, wherever they lie, and
// drops no box with the contact on the way.
#include <array>

#include "fuzz/target.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static constexpr auto kClaims = std::to_array<std::string_view>({
      "tdibm-e.no_false_negative",
      "tdibm-e.trace",
      "tdibm-e.contact_transformed",
  });
  return ccdfuzz::check_bytes_of_any(kClaims, data, size);
}
