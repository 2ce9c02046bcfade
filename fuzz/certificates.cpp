// Certificates that are wrong, as bytes and in case files: the checker refuses each.
#include <array>

#include "fuzz/target.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static constexpr auto kClaims = std::to_array<std::string_view>({
      "checker.refuses_malformed_trees",
      "checker.refuses_touching_leaves",
      "checker.refuses_changed_planes",
      "checker.refuses_changed_boxes",
      "checker.refuses_moved_contacts",
      "checker.refuses_contacts_after_t_max",
      "checker.refuses_clearance_past_a_contact",
      "checker.refuses_wrong_claims",
      "checker.refuses_proofs_before_start",
      "checker.refuses_wrong_trees",
      "checker.refuses_wrong_planes",
      "checker.refuses_wrong_boxes",
      "checker.refuses_wrong_texts",
      "checker.refuses_wrong_witnesses",
      "checker.refuses_wrong_linear_clearances",
      "checker.refuses_wrong_roots",
      "checker.decides_quadratics",
      "checker.refuses_negative_polynomials",
      "checker.sees_nonnegative_rows",
      "miss_tree.round_trip",
  });
  return ccdfuzz::check_bytes_of_any(kClaims, data, size);
}
