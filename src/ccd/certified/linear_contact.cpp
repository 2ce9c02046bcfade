#include "ccd/certified/linear_contact.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "ccd/certified/moment.hpp"
#include "ccd/certified/moving_polygon.hpp"
#include "numeric/next_double.hpp"

namespace ccdfuzz::certified {

namespace {

using Kind = LinearContact::Kind;

/// Halvings after which a polynomial is asked for a repeated root, which no halving parts.
constexpr int kLevelsBeforeGcd = 6;

/// No more than a share of t_max, of which `share` is a quotient of approximations.
double time_below(double share, double t_max) {
  // Law L8: two approximations, 2^-52 each, a quotient and two products are less than 2^-50 in all.
  // A root is 2^-774 at least, and the last product alone may underflow, which one double covers.
  const double product = share * (1 - 0x1p-50) * t_max;
  return product > 0 ? next_down(product) : 0;
}

enum class Touch : std::uint8_t { kNo, kYes, kOpen };

struct SignCount {
  std::size_t above = 0, below = 0, open = 0;

  void add(std::optional<int> sign) {
    open += !sign;
    above += sign && *sign > 0;
    below += sign && *sign < 0;
  }
  bool any() const { return above + below > 0; }
  bool both() const { return above > 0 && below > 0; }
};

class ContactSearch {
 public:
  ContactSearch(MovingPolygon& polygon, double t_max, int level)
      : polygon_(polygon), t_max_(t_max), level_(level) {}

  LinearContact run() {
    const TimePolynomial determinant = polygon_.determinant();
    Moment start({Int(), Int(1)});
    if (start.sign_of(determinant) == 0) try_moment(start);
    if (best_.kind != Kind::kNone) return best_;
    // Law L2: the first contact is 0, a root of the determinant, or else one of what decides.
    if (!determinant.is_zero()) {
      try_roots(determinant);
      return best_;
    }
    for (const bool crosses : {true, false}) {
      for (std::size_t k = 0; k < 3; ++k) {
        bool all_zero = true;
        for (std::size_t i = 0; i < polygon_.corners(); ++i) {
          const TimePolynomial& p = crosses ? polygon_.cross(i, k) : polygon_.corner(i, k);
          all_zero = all_zero && p.is_zero();
          try_roots(p);
        }
        if (!all_zero) return best_;
      }
    }
    return best_;
  }

 private:
  /// The origin is in the polygon at t. Requires that the determinant is 0 there.
  Touch touches(Moment& t) const;
  template <class Of>
  SignCount count_signs(Moment& t, bool quick, const Of& of) const;
  /// The roots of p in (0, 1], one after the other until one is a contact.
  void try_roots(const TimePolynomial& p);
  void try_ratios(const TimePolynomial& p, const TimePolynomial& repeated);
  /// The root −c0/c1 of c0 + c1·t.
  bool try_ratio(const Int& c0, const Int& c1);
  bool try_moment(Moment& t);
  void keep(Kind kind, const TimeRatio& lower_bound);

  MovingPolygon& polygon_;
  const double t_max_;
  const int level_;
  LinearContact best_{Kind::kNone, 0};
};

/// Counts the signs of one component of all crosses, or of one coordinate of all corners. With one
/// above and one below no more are needed, so slow ones come last; if `quick`, they stay open.
template <class Of>
SignCount ContactSearch::count_signs(Moment& t, bool quick, const Of& of) const {
  SignCount count;
  std::array<bool, MovingPolygon::kMostCorners> open{};
  for (std::size_t i = 0; i < polygon_.corners(); ++i) {
    const std::optional<int> sign = t.quick_sign_of(of(i));
    open[i] = !sign;
    count.add(sign);
  }
  for (std::size_t i = 0; i < polygon_.corners() && !quick && !count.both(); ++i) {
    if (!open[i]) continue;
    --count.open;
    count.add(t.sign_of(of(i)));
  }
  return count;
}

Touch ContactSearch::touches(Moment& t) const {
  // A component tells all unless all of it is 0. That is slow to prove, so try the others first.
  for (const bool quick : {true, false}) {
    for (std::size_t k = 0; k < 3; ++k) {
      const SignCount count = count_signs(
          t, quick, [&](std::size_t i) -> auto& { return polygon_.cross(i, k); });
      if (count.both()) return Touch::kNo;  // Law L1 (a)
      if (count.open == 0 && count.any()) return Touch::kYes;
      if (count.open > 0 && !quick) return Touch::kOpen;
    }
  }
  for (std::size_t k = 0; k < 3; ++k) {
    const SignCount count = count_signs(
        t, false, [&](std::size_t i) -> auto& { return polygon_.corner(i, k); });
    if (count.both()) return Touch::kYes;  // Law L1 (b)
    if (count.open > 0) return Touch::kOpen;
    if (count.any()) {
      const bool apart = std::max(count.above, count.below) == polygon_.corners();
      return apart ? Touch::kNo : Touch::kYes;
    }
  }
  return Touch::kYes;  // Law L1 (c)
}

void ContactSearch::keep(Kind kind, const TimeRatio& lower_bound) {
  const Int::Approximation num = lower_bound.num.approximate(), den = lower_bound.den.approximate();
  const double share = std::ldexp(num.mantissa / den.mantissa, num.exponent - den.exponent);
  const double toi = time_below(share, t_max_);
  if (best_.kind == Kind::kNone || toi < best_.toi) best_ = {kind, toi};
}

bool ContactSearch::try_moment(Moment& t) {
  t.narrow(level_);
  const Touch touch = touches(t);
  if (touch == Touch::kNo) return false;
  keep(touch == Touch::kYes ? Kind::kProven : Kind::kOpen, t.lower_bound());
  return true;
}

bool ContactSearch::try_ratio(const Int& c0, const Int& c1) {
  const TimeRatio t = c1.sign() > 0 ? TimeRatio{-c0, c1} : TimeRatio{c0, -c1};
  if (t.num.sign() <= 0 || (t.den - t.num).sign() < 0) return false;
  Moment moment(t);
  return try_moment(moment);
}

/// The roots of p where it has a repeated one; all of them are ratios then. repeated: its greatest
/// common divisor with its derivative.
void ContactSearch::try_ratios(const TimePolynomial& p, const TimePolynomial& repeated) {
  if (repeated.degree() == 2) {  // a constant times (t − root)²
    try_ratio(repeated[1], repeated[2] * 2);
    return;
  }
  try_ratio(repeated[0], repeated[1]);
  // The other root, as the sum of all is −p2/p3.
  if (p.degree() == 3) {
    try_ratio(p[2] * repeated[1] - p[3] * repeated[0] * 2, p[3] * repeated[1]);
  }
}

void ContactSearch::try_roots(const TimePolynomial& p) {
  if (p.degree() <= 0) return;
  if (p.degree() == 1) {
    try_ratio(p[0], p[1]);
    return;
  }
  struct Pending {
    TimePart part;
    SignsOnPart signs;
    bool at_lo;  ///< a root, the lower end of the part
  };
  // Parts with changes of sign, of which splits make no more than the 3 there are, and 3 roots.
  std::array<Pending, 6> pending;
  std::size_t count = 0;
  const auto push = [&](const TimePart& part, const SignsOnPart& signs) {
    if (signs.changes > 0) pending[count++] = {part, signs, false};
  };
  const TimePart whole;
  const SignsOnPart signs = p.signs_on(whole);
  if (signs.zero_at_hi) pending[count++] = {{Int(1), 0}, {}, true};
  push(whole, signs);
  bool asked = false;
  while (count > 0) {
    const Pending next = pending[--count];
    const auto& [part, of_part, at_lo] = next;
    if (at_lo) {
      Moment moment({part.m, Int(1) << part.level});
      if (try_moment(moment)) return;
    } else if (of_part.changes == 1) {  // Law L3: a single root, and it is simple
      Moment moment(p, part);
      if (try_moment(moment)) return;
    } else if (part.level == kMostLevels) {
      keep(Kind::kOpen, {part.m, Int(1) << part.level});
      return;
    } else {
      if (part.level >= kLevelsBeforeGcd && !std::exchange(asked, true)) {
        const TimePolynomial repeated = gcd(p, p.derivative());  // Law L4
        if (repeated.degree() > 0) {
          try_ratios(p, repeated);
          return;
        }
      }
      const TimePart left{part.m << 1, part.level + 1}, right{left.m + Int(1), part.level + 1};
      const SignsOnPart on_left = p.signs_on(left), on_right = p.signs_on(right);
      push(right, on_right);
      if (on_left.zero_at_hi) pending[count++] = {right, {}, true};
      push(left, on_left);
    }
  }
}

}  // namespace

LinearContact first_linear_contact(const Query& query, int level) {
  MovingPolygon polygon;
  if (!polygon.begin(query)) return {};
  return ContactSearch(polygon, query.t_max, level).run();
}

}  // namespace ccdfuzz::certified
