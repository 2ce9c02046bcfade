#pragma once

#include <cstdint>
#include <optional>

#include "ccd/certified/time_polynomial.hpp"

namespace ccdfuzz::certified {

/// Parts of the time step are halved so often at most. No two roots of a determinant are so near to
/// each other (Law L3), and integers on such parts fit (Law L6).
inline constexpr int kMostLevels = 1900;

/// A time, exactly: a ratio, or the only root of a polynomial in an open part.
class Moment {
 public:
  explicit Moment(const TimeRatio& ratio) : ratio_(ratio) {}
  /// Requires: one root in the part, which is simple (Law L3).
  Moment(const TimePolynomial& of, const TimePart& part) : of_(&of), part_(part) {}

  /// Halves the part until it is of this level. A time that turns out to be an end of one is a
  /// ratio from then on.
  void narrow(int level);
  /// The sign of q at this time, if that is quickly told.
  std::optional<int> quick_sign_of(const TimePolynomial& q) const {
    if (of_ == nullptr) return q.sign_at(ratio_);
    const SignsOnPart signs = q.signs_on(part_);
    return signs.changes == 0 ? std::optional(signs.at_lo) : std::nullopt;
  }
  /// The sign of q at this time (Law L5): 0 if a common divisor has the root, otherwise the sign on
  /// a part in which q has none. Nothing if not even a part of kMostLevels tells.
  std::optional<int> sign_of(const TimePolynomial& q);
  /// No more than the time.
  TimeRatio lower_bound() const {
    return of_ == nullptr ? ratio_ : TimeRatio{part_.m, Int(1) << part_.level};
  }

 private:
  /// Takes the part at `place` of the 2^halvings that it is cut into; false if the time is not
  /// there.
  bool take(int halvings, std::int64_t place);
  void halve() {
    if (!take(1, 0)) part_ = {(part_.m << 1) + Int(1), part_.level + 1};
  }

  const TimePolynomial* of_ = nullptr;
  TimePart part_;
  TimeRatio ratio_;
};

}  // namespace ccdfuzz::certified
