#include "generators/draw/draw.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "base/verify.hpp"

namespace ccdfuzz {

namespace {

/// x modulo max + 1, where max + 1 may be 2^64.
std::uint64_t reduced(std::uint64_t x, std::uint64_t max) {
  return max == std::numeric_limits<std::uint64_t>::max() ? x : x % (max + 1);
}

/// The order in which a choice takes the numbers from lo to hi. It is to and fro about the one
/// nearest 0 as long as both sides last (0, +1, −1, +2, …), then on along the longer one.
struct ToAndFro {
  std::int64_t nearest;
  std::uint64_t below, above;

  ToAndFro(std::int64_t lo, std::int64_t hi)
      : nearest(std::clamp<std::int64_t>(0, lo, hi)),
        below(static_cast<std::uint64_t>(nearest - lo)),
        above(static_cast<std::uint64_t>(hi - nearest)) {}

  std::int64_t number(std::uint64_t choice) const {
    const std::uint64_t both = std::min(below, above);
    if (choice > 2 * both) {
      const auto far = static_cast<std::int64_t>(choice - both);
      return above > below ? nearest + far : nearest - far;
    }
    const auto step = static_cast<std::int64_t>((choice + 1) / 2);
    return choice % 2 == 1 ? nearest + step : nearest - step;
  }
  std::uint64_t choice(std::int64_t number) const {
    const std::uint64_t both = std::min(below, above);
    const auto far = static_cast<std::uint64_t>(std::abs(number - nearest));
    if (far > both) return far + both;
    return number > nearest ? 2 * far - 1 : 2 * far;
  }
};

}  // namespace

Draw Draw::from_numbers(ChoiceNumbers numbers) {
  Draw draw(Source::kNumbers, Random(0));
  draw.numbers_ = std::move(numbers);
  return draw;
}

std::uint64_t Draw::supply(std::uint64_t max) {
  switch (source_) {
    case Source::kStream:
      return streamed(max);
    case Source::kMostlySmall: {
      constexpr std::uint64_t kSmall = 7;
      return streamed(random_.coin() ? std::min(max, kSmall) : max);
    }
    case Source::kNumbers:
      break;
  }
  return next_ < numbers_.size() ? reduced(numbers_[next_++], max) : 0;
}

std::uint64_t Draw::chosen(std::uint64_t max) {
  if (max == 0) return 0;
  const std::uint64_t choice = supply(max);
  note(choice, max);
  return choice;
}

void Draw::note(std::uint64_t choice, std::uint64_t max) {
  CCDFUZZ_VERIFY(choice <= max);
  made_.push_back(choice);
  if (watch_) watch_(choice);
}

std::int64_t Draw::between(std::int64_t lo, std::int64_t hi) {
  CCDFUZZ_VERIFY(lo <= hi);
  const ToAndFro order(lo, hi);
  const std::uint64_t most = order.below + order.above;
  if (source_ != Source::kStream) return order.number(chosen(most));
  const std::int64_t number = lo + static_cast<std::int64_t>(random_.below(most + 1));
  if (is_recording_ && most > 0) note(order.choice(number), most);
  return number;
}

Dyadic Draw::dyadic(int bits, long exponent) {
  CCDFUZZ_VERIFY(0 <= bits && bits <= 61);
  const std::int64_t bound = (std::int64_t{1} << bits) - 1;
  return {Integer(static_cast<long>(integer(-bound, bound))), exponent};
}

Dyadic Draw::lattice(int bits, long exponent) {
  CCDFUZZ_VERIFY(0 <= bits && bits <= 61);
  const std::int64_t bound = std::int64_t{1} << bits;
  return {Integer(static_cast<long>(integer(-bound, bound))), exponent};
}

Vec3<Dyadic> Draw::vector(int bits, long exponent) {
  Vec3<Dyadic> v;
  for (int k = 0; k < 3; ++k) v[k] = lattice(bits, exponent);
  return v;
}

double Draw::finite_double() {
  constexpr std::uint64_t kTopExponentBit = std::uint64_t{1} << 62;
  const std::uint64_t bits = choose(std::numeric_limits<std::uint64_t>::max());
  const double x = std::bit_cast<double>(bits);
  return std::isfinite(x) ? x : std::bit_cast<double>(bits & ~kTopExponentBit);
}

double Draw::nudged(double x, int reach) {
  const std::int64_t steps = integer(-reach, reach);
  if (x == 0) return std::ldexp(static_cast<double>(steps), -60);
  const double towards = steps < 0 ? -HUGE_VAL : HUGE_VAL;
  for (std::int64_t i = std::abs(steps); i > 0; --i) x = std::nextafter(x, towards);
  return std::isfinite(x) ? x : std::nextafter(x, 0.0);
}

std::string Draw::text(std::size_t max_size) {
  std::string text(text_size(max_size), '\0');
  for (char& c : text) c = static_cast<char>(choose(255));
  return text;
}

std::size_t Draw::text_size(std::size_t max_size) {
  constexpr std::uint64_t kTypical = 200;
  if (source_ == Source::kNumbers) return std::min(numbers_.size() - next_, max_size);
  return std::min<std::size_t>(random_.below(kTypical + 1), max_size);
}

}  // namespace ccdfuzz
