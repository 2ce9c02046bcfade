#include "properties/choices.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "base/verify.hpp"

namespace ccdfuzz {

namespace {

/// The bytes that a choice with this bound takes.
int width_of(std::uint64_t max) {
  return (static_cast<int>(std::bit_width(max)) + 7) / 8;
}

/// x modulo max + 1, where max + 1 may be 2^64.
std::uint64_t reduced(std::uint64_t x, std::uint64_t max) {
  return max == std::numeric_limits<std::uint64_t>::max() ? x : x % (max + 1);
}

}  // namespace

void append_choice(std::vector<std::uint8_t>& bytes, std::uint64_t choice, int width) {
  for (int i = 0; i < width; ++i) bytes.push_back(static_cast<std::uint8_t>(choice >> (8 * i)));
}

std::uint64_t ChoiceSource::choose(std::uint64_t max) {
  if (max == 0) return 0;
  const std::uint64_t choice = supply(max);
  CCDFUZZ_VERIFY(choice <= max);
  made_.push_back(choice);
  append_choice(bytes_, choice, width_of(max));
  if (watch_) watch_(choice, width_of(max));
  return choice;
}

std::int64_t ChoiceSource::integer(std::int64_t lo, std::int64_t hi) {
  CCDFUZZ_VERIFY(lo <= hi);
  const std::int64_t nearest = std::clamp<std::int64_t>(0, lo, hi);
  const std::uint64_t below = static_cast<std::uint64_t>(nearest - lo);
  const std::uint64_t above = static_cast<std::uint64_t>(hi - nearest);
  const std::uint64_t c = choose(below + above);
  // To and fro as long as both sides last: 0, +1, −1, +2, …; then on along the longer one.
  const std::uint64_t both = std::min(below, above);
  if (c > 2 * both) {
    const auto far = static_cast<std::int64_t>(c - both);
    return above > below ? nearest + far : nearest - far;
  }
  const auto step = static_cast<std::int64_t>((c + 1) / 2);
  return c % 2 == 1 ? nearest + step : nearest - step;
}

Dyadic ChoiceSource::dyadic(int bits, long exponent) {
  CCDFUZZ_VERIFY(0 <= bits && bits <= 61);
  const std::int64_t bound = (std::int64_t{1} << bits) - 1;
  return {Integer(static_cast<long>(integer(-bound, bound))), exponent};
}

double ChoiceSource::finite_double() {
  constexpr std::uint64_t kTopExponentBit = std::uint64_t{1} << 62;
  const std::uint64_t bits = choose(std::numeric_limits<std::uint64_t>::max());
  const double x = std::bit_cast<double>(bits);
  return std::isfinite(x) ? x : std::bit_cast<double>(bits & ~kTopExponentBit);
}

double ChoiceSource::nudged(double x, int reach) {
  const std::int64_t steps = integer(-reach, reach);
  if (x == 0) return std::ldexp(static_cast<double>(steps), -60);
  const double towards = steps < 0 ? -HUGE_VAL : HUGE_VAL;
  for (std::int64_t i = std::abs(steps); i > 0; --i) x = std::nextafter(x, towards);
  return std::isfinite(x) ? x : std::nextafter(x, 0.0);
}

std::string ChoiceSource::text(std::size_t max_size) {
  std::string text(text_size(max_size), '\0');
  for (char& c : text) c = static_cast<char>(choose(255));
  return text;
}

std::uint64_t ByteChoices::supply(std::uint64_t max) {
  const auto width = std::min<std::size_t>(static_cast<std::size_t>(width_of(max)), left_.size());
  std::uint64_t x = 0;
  for (std::size_t i = 0; i < width; ++i) x |= std::uint64_t{left_[i]} << (8 * i);
  left_ = left_.subspan(width);
  return reduced(x, max);
}

std::size_t ByteChoices::text_size(std::size_t max_size) {
  return std::min(left_.size(), max_size);
}

std::uint64_t StoredChoices::supply(std::uint64_t max) {
  return next_ < numbers_.size() ? reduced(numbers_[next_++], max) : 0;
}

std::size_t StoredChoices::text_size(std::size_t max_size) {
  return std::min(numbers_.size() - next_, max_size);
}

std::uint64_t RandomChoices::supply(std::uint64_t max) {
  constexpr std::uint64_t kSmall = 7;
  if (random_.coin()) max = std::min(max, kSmall);
  return max == std::numeric_limits<std::uint64_t>::max() ? random_.next() : random_.below(max + 1);
}

std::size_t RandomChoices::text_size(std::size_t max_size) {
  constexpr std::uint64_t kTypical = 200;
  return std::min<std::size_t>(random_.below(kTypical + 1), max_size);
}

std::string to_hex_bytes(std::span<const std::uint8_t> bytes) {
  std::string text;
  for (const std::uint8_t byte : bytes) text += fmt::format("{:02x}", byte);
  return text;
}

std::string to_hex_word(std::span<const std::uint8_t> bytes) {
  return bytes.empty() ? "''" : to_hex_bytes(bytes);
}

Result<std::vector<std::uint8_t>> parse_hex_bytes(std::string_view text) {
  const auto digit = [](char c) -> int {
    return c >= '0' && c <= '9' ? c - '0' : c >= 'a' && c <= 'f' ? c - 'a' + 10 : -1;
  };
  std::vector<std::uint8_t> bytes;
  for (std::size_t i = 0; i < text.size(); i += 2) {
    const int high = digit(text[i]), low = i + 1 < text.size() ? digit(text[i + 1]) : -1;
    if (high < 0 || low < 0) {
      return input_error("", fmt::format("\"{}\" is not pairs of hex digits 0-9a-f", text));
    }
    bytes.push_back(static_cast<std::uint8_t>(high * 16 + low));
  }
  return bytes;
}

}  // namespace ccdfuzz
