// Lines that are hard to order: the envelope of TDIBM-E bounds them from above, and so does each
// bound that it rests on.
#include <array>

#include "fuzz/target.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static constexpr auto kClaims = std::to_array<std::string_view>({
      "tdibm-e.envelope",
      "tdibm-e.conservative_decisions",
      "tdibm-e.convex_chain",
      "tdibm-e.coefficient_error",
      "tdibm-e.eps_constr",
      "lines.sorting",
      "paper.axis_error",
      "paper.linear_bound",
      "paper.eps_coeff",
      "paper.eps_Phi",
      "paper.eps_phi",
      "paper.eps_arith",
      "paper.Delta_phi",
      "paper.Delta_Phi",
      "paper.theorem_4_1",
  });
  return ccdfuzz::check_bytes_of_any(kClaims, data, size);
}
