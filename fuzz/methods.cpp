// The methods against each other and against themselves, on contacts and near-misses.
#include <array>

#include "fuzz/target.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static constexpr auto kClaims = std::to_array<std::string_view>({
      "methods.not_contradicted",
      "methods.not_contradicted_anywhere",
      "methods.optimised",
      "methods.optimised_alike",
      "methods.no_state",
      "methods.sensible_answers",
      "methods.budget",
      "methods.long_time_step",
      "methods.not_early",
      "methods.split",
      "methods.miss_what_is_far_apart",
      "methods.hit_where_points_meet",
      "methods.scale",
      "methods.scale_time",
      "methods.mirror",
      "judge.sees_misses_and_late_answers",
      "judge.sees_false_positives",
      "judge.keeps_to_terms_of_time",
      "judge.keeps_to_terms_of_space",
  });
  return ccdfuzz::check_bytes_of_any(kClaims, data, size);
}
