// Numbers of every kind that is exact, or says how far it is not, against GMP.
#include <array>

#include "fuzz/target.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static constexpr auto kClaims = std::to_array<std::string_view>({
      "dyadic.round_trip",
      "wide_int.is_gmp",
      "double.parts",
      "double.exact_sums",
      "interval.encloses",
      "interval.is_tight",
      "rational.rounding",
      "paper.rounding",
      "paper.nextafter_bounds",
      "number.texts",
  });
  return ccdfuzz::check_bytes_of_any(kClaims, data, size);
}
