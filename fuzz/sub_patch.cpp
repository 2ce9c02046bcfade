// Any shape, control points on a lattice, any cell: subdivision is exact, and nothing is outside of
// what bounds it.
#include <array>

#include "fuzz/target.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static constexpr auto kClaims = std::to_array<std::string_view>({
      "sub_patch.is_the_restriction",
      "paper.sub_patch_error",
      "cell.children_cover",
      "cell.trees_agree",
      "patch.convex_hull",
      "patch.partition_of_unity",
      "patch.blossom_symmetry",
      "patch.elevation",
  });
  return ccdfuzz::check_bytes_of_any(kClaims, data, size);
}
