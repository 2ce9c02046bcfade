#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include "ccd/line.hpp"
#include "ccd/robustness.hpp"
#include "properties/error_bound.hpp"

namespace ccdfuzz {

using ExactLines = std::vector<Line<Dyadic>>;
using RationalLines = std::vector<Line<Rational>>;

inline Line<Dyadic> exact_line(const Line<double>& line) {
  return {Dyadic::exact(line.slope), Dyadic::exact(line.intercept)};
}

/// The same lines in exact numbers, from any list of them.
template <class List>
ExactLines exact_lines(const List& lines) {
  ExactLines out;
  for (const Line<double>& line : lines) out.push_back(exact_line(line));
  return out;
}

/// A time p/q, q > 0. What is asked at it is multiplied by q, and stays dyadic.
struct Instant {
  Dyadic p, q;
};

inline Dyadic scaled_maximum(const ExactLines& lines, const Instant& t) {
  Dyadic greatest = lines.front().slope * t.p + lines.front().intercept * t.q;
  for (const Line<Dyadic>& line : lines) {
    const Dyadic value = line.slope * t.p + line.intercept * t.q;
    if (greatest < value) greatest = value;
  }
  return greatest;
}

inline Dyadic maximum(const ExactLines& lines, const Dyadic& t) {
  return scaled_maximum(lines, {t, Dyadic(1)});
}

/// lo and hi, and where any two of the lines cross between them: their maximum is linear between
/// those.
inline std::vector<Instant> breakpoints(const ExactLines& lines, const Dyadic& lo,
                                        const Dyadic& hi) {
  std::vector<Instant> out = {{lo, Dyadic(1)}, {hi, Dyadic(1)}};
  for (const Line<Dyadic>& x : lines) {
    for (const Line<Dyadic>& y : lines) {
      const Dyadic q = x.slope - y.slope, p = y.intercept - x.intercept;
      if (q.sign() > 0 && lo * q <= p && p <= hi * q) out.push_back({p, q});
    }
  }
  return out;
}

/// Both forms of predicates on differences of lines, in any number type.
template <class S>
ProductDifference<S> product_form(const Line<S>& x, const Line<S>& y, const Line<S>& z) {
  return {S(z.slope - x.slope), S(y.intercept - x.intercept), S(y.slope - x.slope),
          S(z.intercept - x.intercept)};
}
template <class S>
EndValue<S> end_form(const Line<S>& x, const Line<S>& y, const S& t) {
  return {S(x.slope - y.slope), S(x.intercept - y.intercept), t};
}

/// The least and the greatest intercept.
inline std::array<Dyadic, 2> intercept_range(const ExactLines& lines) {
  std::array<Dyadic, 2> out = {lines[0].intercept, lines[0].intercept};
  for (const Line<Dyadic>& line : lines) {
    out[0] = std::min(out[0], line.intercept);
    out[1] = std::max(out[1], line.intercept);
  }
  return out;
}

/// eps_arith of lines by rising slope up to t (Eq. 16): I·B·[(1 + eps)^4 − 1], B the larger of
/// 4 Delta_b and t·Delta_a + Delta_b.
inline Dyadic eps_arith(const ExactLines& sorted, const Dyadic& t) {
  const auto [lowest, highest] = intercept_range(sorted);
  const Dyadic delta_b = highest - lowest;
  const Dyadic swept = t * (sorted.back().slope - sorted[0].slope) + delta_b;
  return Dyadic(static_cast<int>(sorted.size())) *
         theorem_4_1_bound(std::max(delta_b.scaled(2), swept), 4);
}

/// The times of [lo, hi] at which max lower < min upper: an interval from `from` to `to`, each end
/// separated or not. By all pairs of lines, without envelopes.
struct SeparatedTimes {
  Rational from, to;
  bool from_included = false, to_included = false;

  bool contains(const Rational& t) const {
    return (from < t || (from_included && from == t)) && (t < to || (to_included && to == t));
  }
};

inline std::optional<SeparatedTimes> separated_times(const RationalLines& lower,
                                                     const RationalLines& upper, const Rational& lo,
                                                     const Rational& hi) {
  SeparatedTimes s{lo, hi, true, true};
  for (const Line<Rational>& f : lower) {
    for (const Line<Rational>& g : upper) {
      const Rational slope = f.slope - g.slope, height = f.intercept - g.intercept;
      if (sgn(slope) == 0) {
        if (sgn(height) >= 0) return std::nullopt;
        continue;
      }
      const Rational root = -height / slope;  // itself not separated
      if (sgn(slope) > 0 && root <= s.to) s.to = root, s.to_included = false;
      if (sgn(slope) < 0 && root >= s.from) s.from = root, s.from_included = false;
    }
  }
  if (s.from > s.to || (s.from == s.to && !(s.from_included && s.to_included))) {
    return std::nullopt;
  }
  return s;
}

}  // namespace ccdfuzz
