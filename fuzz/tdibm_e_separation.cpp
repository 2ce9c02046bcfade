// Lines that are hard to order: TDIBM-E separates only what is separated, in each of its steps.
#include <array>

#include "fuzz/target.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static constexpr auto kClaims = std::to_array<std::string_view>({
      "tdibm-e.separation",
      "tdibm-e.ends",
      "tdibm-e.pulled_roots",
      "tdibm-e.safe_roots",
      "tdibm-e.safe_roots_of_sums",
      "paper.eps_Psi",
      "paper.eps_tau",
      "paper.overlap",
      "paper.one_interval",
      "paper.steps_are_exact",
      "paper.step_three",
      "tdibm.ends",
  });
  return ccdfuzz::check_bytes_of_any(kClaims, data, size);
}
