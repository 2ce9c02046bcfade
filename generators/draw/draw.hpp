#pragma once

#include <array>
#include <concepts>
#include <cstdint>
#include <exception>
#include <functional>
#include <string>
#include <type_traits>
#include <vector>

#include "generators/draw/random.hpp"
#include "numeric/dyadic.hpp"
#include "numeric/exact_scalars.hpp"

namespace ccdfuzz {

/// The numbers that a source gave, in turn.
using ChoiceNumbers = std::vector<std::uint64_t>;

/// What was drawn is no input: until() found nothing that it may take.
struct Discarded : std::exception {
  const char* what() const noexcept override { return "the choices make no such input"; }
};

/// Where everything that is drawn comes from: a sequence of choices, each a whole number from 0 to
/// a bound. Its source is a random stream, or stored numbers, which a fuzzer has as bytes
/// (choice_bytes.hpp). 0 is the simplest choice everywhere, and what stored numbers give at their
/// end, so that shorter and smaller sequences are simpler inputs, whoever shrinks them. One draw
/// per statement: the order in which a compiler evaluates the arguments of a call is its own
/// affair.
class Draw {
 public:
  /// Uniform: of this stream data sets are made, the same everywhere. Keeps no record of its
  /// choices until record() is called; every other source does from the beginning.
  explicit Draw(Random stream) : source_(Source::kStream), random_(stream) {}
  /// Half of them uniform, half of them among the eight smallest, because what breaks geometry are
  /// coincidences.
  static Draw mostly_small(Random stream) { return {Source::kMostlySmall, stream}; }
  /// Each number modulo bound + 1.
  static Draw from_numbers(ChoiceNumbers numbers);

  /// A number in [0, max].
  std::uint64_t choose(std::uint64_t max) {
    if (source_ == Source::kStream && !is_recording_) return streamed(max);
    return chosen(max);
  }
  /// A number in [0, bound), bound ≥ 1.
  std::uint64_t below(std::uint64_t bound) { return choose(bound - 1); }
  /// A number in [lo, hi], of the type of these; the one nearest 0 is the simplest. Requires
  /// lo ≤ hi, hi − lo < 2^63.
  template <std::integral Low, std::integral High>
  std::common_type_t<Low, High> integer(Low lo, High hi) {
    return static_cast<std::common_type_t<Low, High>>(
        between(static_cast<std::int64_t>(lo), static_cast<std::int64_t>(hi)));
  }
  bool coin() { return choose(1) != 0; }
  /// m·2^exponent with |m| < 2^bits, bits ≤ 61.
  Dyadic dyadic(int bits, long exponent);
  /// m·2^exponent with |m| ≤ 2^bits, bits ≤ 61.
  Dyadic lattice(int bits, long exponent);
  /// Three of those.
  Vec3<Dyadic> vector(int bits, long exponent);
  /// Any finite double: subnormal, −0 and the largest ones as likely as others.
  double finite_double();
  /// x moved up or down by at most `reach` floats. 0 is moved by as many multiples of 2^-60, since
  /// no rounding error of ordinary numbers is as small as a subnormal.
  double nudged(double x, int reach);
  template <class From>
  const auto& pick(const From& from) {
    return from[below(from.size())];
  }
  /// Bytes, at most max_size of them: of stored numbers, one for each that is left. So nothing else
  /// is drawn after a text.
  std::string text(std::size_t max_size);

  /// The first of make() that is good. A random source goes on until there is one. Stored numbers
  /// could give bad ones for ever: after kMostTries of them, or the first after their end,
  /// Discarded is thrown. What was refused is not among numbers(), so these give the same at once.
  template <class Make, class Good>
  auto until(const Make& make, const Good& good) {
    for (int tries = 1;; ++tries) {
      const std::size_t before = made_.size();
      auto made = make();
      if (good(made)) return made;
      if (source_ == Source::kNumbers && (tries == kMostTries || is_at_end())) throw Discarded();
      made_.resize(before);
    }
  }
  static constexpr int kMostTries = 64;

  /// From now on keeps the choices of a stream too.
  void record() { is_recording_ = true; }
  /// The choices that were made, for from_numbers().
  const ChoiceNumbers& numbers() const { return made_; }

  /// Called with each choice as soon as it is made.
  using Watch = std::function<void(std::uint64_t choice)>;
  void watch(Watch watch) { watch_ = std::move(watch); }

  /// Where whoever draws tells what it made of the choices; null unless somebody listens.
  std::string* story() const { return story_; }
  void tell_to(std::string* story) { story_ = story; }

 private:
  enum class Source : std::uint8_t { kStream, kMostlySmall, kNumbers };

  Draw(Source source, Random random)
      : source_(source), is_recording_(source != Source::kStream), random_(random) {}

  std::int64_t between(std::int64_t lo, std::int64_t hi);
  bool is_at_end() const { return next_ == numbers_.size(); }
  std::uint64_t streamed(std::uint64_t max) {
    return max == ~std::uint64_t{0} ? random_.next() : random_.below(max + 1);
  }
  std::uint64_t supply(std::uint64_t max);
  std::uint64_t chosen(std::uint64_t max);
  void note(std::uint64_t choice, std::uint64_t max);
  std::size_t text_size(std::size_t max_size);

  Source source_;
  bool is_recording_ = false;
  Random random_;
  ChoiceNumbers numbers_;  ///< the stored choices
  std::size_t next_ = 0;   ///< the next of them
  ChoiceNumbers made_;
  Watch watch_;
  std::string* story_ = nullptr;
};

}  // namespace ccdfuzz
