#include "numeric/effort.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cstdlib>
#include <string>

namespace ccdfuzz {

Result<std::uint64_t> effort() {
  constexpr std::uint64_t kMost = 1'000'000;
  const char* const set = std::getenv("CCDFUZZ_EFFORT");
  if (set == nullptr || *set == '\0') return 1;
  const std::string text = set;
  const char* const end = text.data() + text.size();
  std::uint64_t factor = 0;
  const auto [rest, status] = std::from_chars(text.data(), end, factor);
  const bool whole = status == std::errc() && rest == end && text[0] != '0';
  if (whole && factor <= kMost) return factor;
  return input_error("CCDFUZZ_EFFORT",
                     fmt::format("\"{}\" is not a whole number from 1 to {}", text, kMost));
}

}  // namespace ccdfuzz
