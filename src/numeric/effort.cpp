#include "numeric/effort.hpp"

#include <cstdlib>

#include "base/number_text.hpp"

namespace ccdfuzz {

Result<std::uint64_t> effort() {
  constexpr std::uint64_t kMost = 1'000'000;
  const char* const set = std::getenv("CCDFUZZ_EFFORT");
  if (set == nullptr || *set == '\0') return 1;
  return parse_whole("CCDFUZZ_EFFORT", set, 1, kMost);
}

}  // namespace ccdfuzz
