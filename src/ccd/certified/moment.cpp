#include "ccd/certified/moment.hpp"

#include <cmath>
#include <utility>

namespace ccdfuzz::certified {

bool Moment::take(int halvings, std::int64_t place) {
  const TimePart inner{(part_.m << halvings) + Int(place), part_.level + halvings};
  const SignsOnPart signs = of_->signs_on(inner);
  // The ends of the whole part may be other roots.
  const bool at_lo = signs.zero_at_lo && place > 0;
  const bool at_hi = signs.zero_at_hi && place + 1 < std::int64_t{1} << halvings;
  if (at_lo || at_hi) {
    ratio_ = {at_lo ? inner.m : inner.m + Int(1), Int(1) << inner.level};
    of_ = nullptr;
    return true;
  }
  if (!signs.odd_roots()) return false;
  part_ = inner;
  return true;
}

void Moment::narrow(int level) {
  int next = level;
  while (of_ != nullptr && part_.level < level) {
    // The part where a guess lies, the narrower the better; a half is always right.
    const int halvings = next - part_.level;
    if (halvings <= 1) {
      halve();
    } else {
      const double share = std::ldexp(of_->guess_root(part_), halvings);
      if (!take(halvings, static_cast<std::int64_t>(share))) {
        next = part_.level + halvings / 2;
        continue;
      }
    }
    next = level;
  }
}

std::optional<int> Moment::sign_of(const TimePolynomial& q) {
  for (bool asked = false; true; halve()) {
    if (const std::optional<int> sign = quick_sign_of(q)) return sign;
    // Law L5: a common divisor has no other root here than the one of `of_`, and that once.
    if (!std::exchange(asked, true) && gcd(*of_, q).signs_on(part_).odd_roots()) return 0;
    if (part_.level >= kMostLevels) return std::nullopt;
  }
}

}  // namespace ccdfuzz::certified
