#include "ccd/certified/short_contact.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "ccd/certified/guess_root.hpp"
#include "ccd/certified/moving_polygon.hpp"
#include "ccd/certified/short_polynomial.hpp"

namespace ccdfuzz::certified {

namespace {

using ShortPolygon = MovingPolygon<ShortIntegers>;
using Determinant = ShortIntegers::Determinant;
using Cross = ShortIntegers::Cross;

constexpr std::int64_t kParts = std::int64_t{1} << kShortLevel;
constexpr double kPart = 0x1p-44;
static_assert(kPart * kParts == 1);
/// Halvings after which roots that are not yet parted are left to longer integers.
constexpr int kMostSplits = 6;

/// A time within radius of centre; the times named by `part` unless that is negative.
struct ShortMoment {
  double centre = 0, radius = 0;
  std::int64_t part = -1;  ///< in [part, part + 1]·2^-level, or at its lower end if the radius is 0
  double lower_bound = 0;
};

class ShortSearch {
 public:
  explicit ShortSearch(ShortPolygon& polygon)
      : polygon_(polygon), determinant_(polygon.determinant()), rough_(determinant_) {}

  std::optional<ShortAnswer> run() {
    if (rough_.c == std::array<double, 4>{}) return std::nullopt;
    const SignsOnPart signs = determinant_.signs();
    if (signs.zero_at_lo) try_moment(moment_at(0));
    try_part(0, 0, signs, rough_);
    if (signs.zero_at_hi) try_moment(moment_at(kParts));
    return answer_;
  }

 private:
  static ShortMoment moment_at(std::int64_t m) {
    const double time = static_cast<double>(m) * kPart;
    return {time, 0, m, time};
  }
  /// At m·2^-kShortLevel.
  int sign_at(std::int64_t m) const {
    const auto sign = rough_.sign_about(static_cast<double>(m) * kPart, 0);
    return sign ? *sign : determinant_.on_part<576>(m, kShortLevel).c[0].sign();
  }
  /// What is not yet known: neither a contact nor an open question.
  bool goes_on() const { return answer_ && !answer_->touch; }

  /// The roots inside of (m, m + 1)·2^-level. rough: the determinant there.
  void try_part(std::int64_t m, int level, const SignsOnPart& signs,
                const RoughPolynomial<3>& rough);
  /// The only root there, a simple one. share: where it may be.
  ShortMoment root_in(std::int64_t m, int level, int first, double share) const;
  void try_moment(const ShortMoment& t);

  ShortPolygon& polygon_;
  const Determinant determinant_;
  const RoughPolynomial<3> rough_;
  /// The answer about what has been looked at; nothing if that is not decided.
  std::optional<ShortAnswer> answer_ = ShortAnswer{false};
};

void ShortSearch::try_part(std::int64_t m, int level, const SignsOnPart& signs,
                           const RoughPolynomial<3>& rough) {
  if (!goes_on() || signs.changes == 0) return;
  if (signs.changes == 1) {
    if (rough_.c[2] == 0 && rough_.c[3] == 0) {
      // Both approximations and the quotient err by 5·2^-53 in all.
      const double root = -rough_.c[0] / rough_.c[1];
      try_moment({root, 0x1p-50 * root, -1, root});
    } else {
      try_moment(root_in(m, level, signs.at_lo, guess_root(rough.c)));
    }
    return;
  }
  if (level == kMostSplits) {
    answer_.reset();
    return;
  }
  const auto left = determinant_.on_part<576>(2 * m, level + 1),
             right = determinant_.on_part<576>(2 * m + 1, level + 1);
  const SignsOnPart on_left = left.signs();
  try_part(2 * m, level + 1, on_left, RoughPolynomial<3>(left));
  if (on_left.zero_at_hi && goes_on()) {
    try_moment(moment_at((2 * m + 1) << (kShortLevel - level - 1)));
  }
  try_part(2 * m + 1, level + 1, right.signs(), RoughPolynomial<3>(right));
}

/// From the guess on in steps twice as long each, then by halves.
ShortMoment ShortSearch::root_in(std::int64_t part, int level, int first, double share) const {
  const std::int64_t length = kParts >> level;
  std::int64_t lo = part * length, hi = lo + length, step = 1;
  std::int64_t m = lo + static_cast<std::int64_t>(share * static_cast<double>(length));
  while (hi - lo > 1) {
    if (m <= lo || m >= hi) m = lo + (hi - lo) / 2;
    const int sign = sign_at(m);
    if (sign == 0) return moment_at(m);
    if (sign == first) {
      lo = m;
      m = lo + step;
    } else {
      hi = m;
      m = hi - step;
    }
    step = std::min(2 * step, length);
  }
  const double time = static_cast<double>(lo) * kPart;
  return {time + 0.5 * kPart, 0.5 * kPart, lo, time};
}

std::optional<int> sign_at(const Cross& exact, const ShortMoment& t) {
  const auto sign = RoughPolynomial<2>(exact).sign_about(t.centre, t.radius);
  if (sign || t.part < 0) return sign;
  // Law L10: on a part of level 44 a cross has 343 bits.
  const auto on_part = exact.on_part<384>(t.part, kShortLevel);
  if (t.radius == 0) return on_part.c[0].sign();
  const SignsOnPart signs = on_part.signs();
  return signs.changes == 0 ? std::optional(signs.at_lo) : std::nullopt;
}

/// Whether the origin is in the polygon, unless a sign is open.
std::optional<bool> touches(ShortPolygon& polygon, const ShortMoment& t) {
  for (std::size_t k = 0; k < 3; ++k) {
    bool above = false, below = false, open = false;
    for (std::size_t i = 0; i < polygon.corners() && !(above && below); ++i) {
      const std::optional<int> sign = sign_at(polygon.cross(i, k), t);
      open = open || !sign;
      above = above || (sign && *sign > 0);
      below = below || (sign && *sign < 0);
    }
    if (above && below) return false;  // Law L1 (a)
    if (!open && (above || below)) return true;
  }
  return std::nullopt;
}

void ShortSearch::try_moment(const ShortMoment& t) {
  if (!goes_on()) return;
  const std::optional<bool> touch = touches(polygon_, t);
  if (!touch) {
    answer_.reset();
  } else if (*touch) {
    answer_ = {true, t.lower_bound};
  }
}

}  // namespace

std::optional<ShortAnswer> short_contact(const Query& query) {
  ShortPolygon polygon;
  if (!polygon.begin(query)) return std::nullopt;
  return ShortSearch(polygon).run();
}

}  // namespace ccdfuzz::certified
