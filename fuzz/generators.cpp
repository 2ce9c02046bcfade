// The generators: what they make is what it says.
#include <array>

#include "fuzz/target.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static constexpr auto kClaims = std::to_array<std::string_view>({
      "generator.coincidence",
      "generator.tangency",
      "generator.extraction",
      "generator.motion",
      "generator.first_contact",
      "generator.cases",
      "generator.other_contacts",
      "generator.grazing",
      "generator.grazing_shapes",
      "generator.clearance",
      "generator.refuses_planes",
  });
  return ccdfuzz::check_bytes_of_any(kClaims, data, size);
}
