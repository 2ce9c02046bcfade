// Two patches in contact, tiny ones too: certified TDIBM says so in time, however they are moved,
// written or cut, and drops no box with the contact on the way.
#include <array>

#include "fuzz/target.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static constexpr auto kClaims = std::to_array<std::string_view>({
      "tdibm-c.no_false_negative",
      "tdibm-c.no_false_negative_underflow",
      "tdibm-c.no_false_negative_anywhere",
      "tdibm-c.no_false_negative_fine",
      "tdibm-c.no_false_negative_linear",
      "tdibm-c.trace",
      "tdibm-c.normalised",
      "tdibm-c.sub_patches",
      "tdibm-c.error_bound",
      "tdibm-c.windows",
      "tdibm-c.contact_swapped",
      "tdibm-c.contact_reparametrised",
      "tdibm-c.contact_permuted",
      "tdibm-c.contact_mirrored",
      "tdibm-c.contact_translated",
      "tdibm-c.contact_drifting",
      "tdibm-c.contact_backwards",
      "tdibm-c.contact_elevated",
      "tdibm-c.contact_in_a_part",
  });
  return ccdfuzz::check_bytes_of_any(kClaims, data, size);
}
