#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "generators/random.hpp"
#include "numeric/dyadic.hpp"

namespace ccdfuzz {

/// Where the inputs of a property come from: a sequence of choices, each a whole number from 0 to
/// a bound. What supplies the numbers is the driver's affair: libFuzzer's bytes, RapidCheck, a
/// stored sequence. 0 is the simplest choice everywhere, and what a source at its end gives, so
/// that shorter and smaller sequences are simpler inputs, whoever shrinks them.
class ChoiceSource {
 public:
  virtual ~ChoiceSource() = default;

  /// A number in [0, max].
  std::uint64_t choose(std::uint64_t max);

  /// A number in [lo, hi]; the one nearest 0 is the simplest. Requires lo ≤ hi, hi − lo < 2^63.
  std::int64_t integer(std::int64_t lo, std::int64_t hi);
  bool coin() { return choose(1) != 0; }
  /// m·2^exponent with |m| < 2^bits, bits ≤ 61.
  Dyadic dyadic(int bits, long exponent);
  /// Any finite double: subnormal, −0 and the largest ones as likely as others.
  double finite_double();
  /// x moved up or down by at most `reach` floats; 0 by as many multiples of 2^-60 instead, since a
  /// subnormal is not near 0 in the sense of any rounding error.
  double nudged(double x, int reach);
  template <class T, std::size_t N>
  const T& pick(const std::array<T, N>& from) {
    return from[choose(N - 1)];
  }
  /// Bytes, at most max_size of them.
  std::string text(std::size_t max_size);

  /// The choices made so far, as the bytes from which ByteChoices makes the same again.
  const std::vector<std::uint8_t>& bytes() const { return bytes_; }
  /// The same as numbers, for StoredChoices.
  const std::vector<std::uint64_t>& numbers() const { return made_; }

  /// Called with each choice as soon as it is made, and the number of bytes that it is of bytes().
  using Watch = std::function<void(std::uint64_t choice, int bytes)>;
  void watch(Watch watch) { watch_ = std::move(watch); }

 private:
  /// A number in [0, max], max ≥ 1.
  virtual std::uint64_t supply(std::uint64_t max) = 0;
  /// How many bytes are left, where that means anything; what text() takes as its length.
  virtual std::size_t text_size(std::size_t max_size) = 0;

  std::vector<std::uint8_t> bytes_;
  std::vector<std::uint64_t> made_;
  Watch watch_;
};

/// Choices from a fuzzer's bytes: each takes as many whole bytes, lowest first, as its bound needs,
/// and the remainder after division by bound + 1. So one byte changes one choice only.
class ByteChoices : public ChoiceSource {
 public:
  explicit ByteChoices(std::span<const std::uint8_t> bytes) : left_(bytes) {}

 private:
  std::uint64_t supply(std::uint64_t max) override;
  std::size_t text_size(std::size_t max_size) override;

  std::span<const std::uint8_t> left_;
};

/// Choices from stored numbers, each reduced modulo bound + 1.
class StoredChoices : public ChoiceSource {
 public:
  explicit StoredChoices(std::vector<std::uint64_t> numbers) : numbers_(std::move(numbers)) {}

 private:
  std::uint64_t supply(std::uint64_t max) override;
  std::size_t text_size(std::size_t max_size) override;

  std::vector<std::uint64_t> numbers_;
  std::size_t next_ = 0;
};

/// Choices drawn at random: half of them uniform, half of them among the eight smallest, because
/// what breaks geometry are coincidences.
class RandomChoices : public ChoiceSource {
 public:
  explicit RandomChoices(Random random) : random_(random) {}

 private:
  std::uint64_t supply(std::uint64_t max) override;
  std::size_t text_size(std::size_t max_size) override;

  Random random_;
};

/// One more choice, as it stands in so many bytes.
void append_choice(std::vector<std::uint8_t>& bytes, std::uint64_t choice, int width);

/// "00ff1a": how choices stand in messages and on command lines.
std::string to_hex_bytes(std::span<const std::uint8_t> bytes);
/// The same as one word of a shell, which '' is for no bytes.
std::string to_hex_word(std::span<const std::uint8_t> bytes);
Result<std::vector<std::uint8_t>> parse_hex_bytes(std::string_view text);

}  // namespace ccdfuzz
