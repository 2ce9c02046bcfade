// Linear queries, degenerate above all: two exact codes that share nothing agree.
#include <array>

#include "fuzz/target.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static constexpr auto kClaims = std::to_array<std::string_view>({
      "linear.decision_is_proven",
      "checker.refuses_wrong_linear_clearances",
      "checker.refuses_wrong_roots",
  });
  return ccdfuzz::check_bytes_of_any(kClaims, data, size);
}
