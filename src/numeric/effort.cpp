#include "numeric/effort.hpp"

#include <fmt/format.h>

#include <cstdlib>

#include "base/number_text.hpp"

namespace ccdfuzz {

Result<std::uint64_t> effort() {
  constexpr std::uint64_t kMost = 1'000'000;
  const char* const set = std::getenv("CCDFUZZ_EFFORT");
  if (set == nullptr || *set == '\0') return 1;
  const auto factor = parse_whole("CCDFUZZ_EFFORT", set);
  if (factor && 1 <= *factor && *factor <= kMost) return *factor;
  return input_error("CCDFUZZ_EFFORT",
                     fmt::format("\"{}\" is not a whole number from 1 to {}", set, kMost));
}

}  // namespace ccdfuzz
