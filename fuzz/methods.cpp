// The methods against each other and against themselves, on contacts and near-misses.
#include <array>

#include "fuzz/target.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static constexpr std::array<std::string_view, 7> kClaims = {
      "methods.not_contradicted",
      "methods.optimised",
      "methods.no_state",
      "methods.sensible_answers",
      "methods.scale",
      "methods.mirror",
      "tdibm.swap",
  };
  return ccdfuzz::check_bytes_of_any(kClaims, data, size);
}
