#pragma once

#include <cmath>
#include <string>

#include "ccd/line.hpp"
#include "ccd/time_interval.hpp"
#include "generators/draw/draw.hpp"
#include "numeric/exact_scalars.hpp"
#include "numeric/rational.hpp"

namespace ccdfuzz {

/// What Steps II and III work on: the sorted lines of one patch, the sorted negated lines of the
/// other, and a window.
struct LineProblem {
  Lines<double> f, g;
  TimeWindow<double> w;
};

inline std::string to_text(const Lines<double>& lines) {
  std::string text;
  for (const Line<double>& l : lines) {
    text += "  {" + to_hex(l.slope) + ", " + to_hex(l.intercept) + "},\n";
  }
  return text;
}

inline std::string to_text(const LineProblem& p) {
  return "f:\n" + to_text(p.f) + "g:\n" + to_text(p.g) + "w: [" + to_hex(p.w.lo) + ", " +
         to_hex(p.w.hi) + "]\n";
}

inline Lines<Rational> exact(const Lines<double>& lines) {
  Lines<Rational> out;
  for (const Line<double>& l : lines) out.push_back({exact(l.slope), exact(l.intercept)});
  return out;
}

inline TimeWindow<Rational> exact(const TimeWindow<double>& w) {
  return {exact(w.lo), exact(w.hi)};
}

/// x moved by a few units in its last place; zero stays, so that nothing underflows.
inline double nudged(Draw& random, double x, int ulps) {
  const std::int64_t steps = random.integer(-ulps, ulps);
  for (std::int64_t i = 0; i < std::abs(steps) && x != 0; ++i) {
    x = std::nextafter(x, steps < 0 ? -INFINITY : INFINITY);
  }
  return x;
}

/// A multiple of 2^-bits in [−1, 1].
inline double fraction(Draw& random, int bits) {
  return std::ldexp(static_cast<double>(random.integer(-(1 << bits), 1 << bits)), -bits);
}

/// A line of `lines` again, a few ulps off.
inline Line<double> twin(Draw& random, const Lines<double>& lines) {
  const Line<double> line = lines[static_cast<int>(random.below(lines.size()))];
  const double slope = nudged(random, line.slope, 40);
  const double intercept = nudged(random, line.intercept, 60);
  return {slope, intercept};
}

/// Lines through a common point, give or take an ulp, and twins of them. Control points on a plane
/// look so, along an axis nearly normal to it. Every predicate of Steps II and III is nearly zero
/// there. The point lies in the window or at one of its ends.
inline LineProblem concurrent_lines(Draw& random) {
  LineProblem p;
  const double t = std::abs(fraction(random, random.coin() ? 3 : 30));
  const double height = random.coin() ? 0 : fraction(random, 20);
  p.w = {random.coin() ? 0 : t * std::abs(fraction(random, 20)), 1};
  const std::uint64_t ends = random.below(5);
  if (ends == 0) p.w.hi = t;
  if (ends == 1) p.w.lo = t;
  if (ends == 2) p.w.lo = nudged(random, t, 4);
  p.w.hi = std::max(p.w.hi, p.w.lo);
  for (Lines<double>* lines : {&p.f, &p.g}) {
    const double at_t = lines == &p.f ? height : -height;
    const std::int64_t count = random.integer(1, 6);
    for (std::int64_t i = 0; i < count; ++i) {
      if (i > 0 && random.coin()) {
        lines->push_back(twin(random, *lines));
        continue;
      }
      const double slope = fraction(random, random.coin() ? 3 : 30);
      // Some pass below the point: redundant there, perhaps the maximum elsewhere.
      const double below = random.below(3) == 0 ? std::abs(fraction(random, 3)) : 0;
      lines->push_back({slope, nudged(random, at_t - slope * t - below, 2)});
    }
    sort_lines(*lines);
  }
  return p;
}

/// Four lines of which the third is a twin of the second, redundant or nearly so, and the fourth
/// may make both redundant: then the twin shields the second in the test against the fourth.
inline LineProblem shielded_lines(Draw& random) {
  LineProblem p;
  p.w = {0, 1};
  const double first = fraction(random, 4) - 1, middle = fraction(random, 4),
               last = middle + std::abs(fraction(random, 4));
  p.f.push_back({first, fraction(random, 4)});
  p.f.push_back({middle, fraction(random, 4)});
  p.f.push_back({nudged(random, middle, 4), nudged(random, p.f[1].intercept, 4)});
  p.f.push_back({last, fraction(random, 4)});
  p.g.push_back({fraction(random, 4) - 1, fraction(random, 4)});
  if (random.coin()) p.g.push_back({fraction(random, 4), fraction(random, 4)});
  sort_lines(p.f);
  sort_lines(p.g);
  if (random.coin()) std::swap(p.f, p.g);
  return p;
}

}  // namespace ccdfuzz
