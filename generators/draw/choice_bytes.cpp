#include "generators/draw/choice_bytes.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/number_text.hpp"
#include "base/text.hpp"

namespace ccdfuzz {

namespace {

constexpr int kBits = 7;
constexpr std::uint8_t kMore = 1 << kBits;

}  // namespace

std::vector<std::uint8_t> bytes_of(const ChoiceNumbers& numbers) {
  std::vector<std::uint8_t> bytes;
  for (std::uint64_t x : numbers) {
    for (; x >= kMore; x >>= kBits) bytes.push_back(static_cast<std::uint8_t>(x | kMore));
    bytes.push_back(static_cast<std::uint8_t>(x));
  }
  return bytes;
}

ChoiceNumbers choices_of(std::span<const std::uint8_t> bytes) {
  ChoiceNumbers numbers;
  bool is_open = false;
  int shift = 0;
  for (const std::uint8_t byte : bytes) {
    if (!is_open) numbers.push_back(0), shift = 0;
    if (shift < 64) numbers.back() |= std::uint64_t{byte & (kMore - 1U)} << shift;
    shift += kBits;
    is_open = (byte & kMore) != 0;
  }
  return numbers;
}

std::string to_word(const ChoiceNumbers& numbers) {
  return numbers.empty() ? "''" : fmt::format("{}", fmt::join(numbers, ","));
}

Result<ChoiceNumbers> parse_choices(const std::string& text) {
  ChoiceNumbers numbers;
  if (text.empty()) return numbers;
  for (const std::string& word : texts_between(text)) {
    CCDFUZZ_TRY(const std::uint64_t x, parse_whole("", word));
    numbers.push_back(x);
  }
  return numbers;
}

}  // namespace ccdfuzz
