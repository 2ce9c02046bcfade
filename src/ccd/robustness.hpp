#pragma once

#include <algorithm>
#include <cmath>

#include "ccd/line.hpp"
#include "ccd/reading.hpp"
#include "ccd/time_interval.hpp"
#include "numeric/next_double.hpp"

namespace ccdfuzz {

/// The two forms of every predicate of Steps II and III, on differences of numbers that count as
/// exact. value() is the predicate, magnitude() and kRoundings its B and k of Theorem 4.1.

/// p·q − r·s (Eqs. 5a, 8a, 9a). A difference has k = 1, a product of two 1+1+1, their difference 4.
template <class S>
struct ProductDifference {
  S p, q, r, s;
  static constexpr int kRoundings = 4;

  S value() const { return S(S(p * q) - S(r * s)); }
  S magnitude() const {
    using std::abs;
    return S(S(abs(S(p * q))) + S(abs(S(r * s))));
  }
};

/// slope·t + intercept at an end t of the window (Eqs. 5b, 6, 7, 8b, 9b): k = max(1+1, 1) + 1.
template <class S>
struct EndValue {
  S slope, intercept, t;
  static constexpr int kRoundings = 3;

  S value() const { return S(S(slope * t) + intercept); }
  S magnitude() const {
    using std::abs;
    return S(S(abs(S(slope * t))) + S(abs(intercept)));
  }
};

/// B and k of the rounding errors that Step I left in slopes and intercepts (Appendix A), as the
/// absolute errors eps_a and eps_b.
struct CoefficientError {
  double slope = 0;
  double intercept = 0;
};

/// A robustness policy is how a method guards Steps II and III. Every policy has
///   negative(predicate)     the predicate decides for "< 0": push a line, accept a crossing
///   redundant(predicate)    Phi decides that the top of the stack goes
///   pulled(intercept)       the intercept of a line, before Step II
///   envelope_error(...)     eps_constr of a set of lines
///   raise(envelope, e)      what becomes of an envelope, after Step II, e = eps_constr
///   starts_below(f, g, t)   Eq. 7: is f[0] + g[0] < 0 at the start t of the window?
///   left_root, right_root   where f[i] + g[j] = 0 (Eq. 10), as the left or the right end of a
///                           separated interval
/// kBoundsErrors says whether it reads the errors of Step I at all. kAdvancesBoth says whether the
/// sweep of Step III goes on along both envelopes where both tests of a pair of lines fail.
/// kReading says how the rest of the method is read.

/// Section 3, as if arithmetic were exact; with S = Rational it is.
struct Plain {
  static constexpr bool kBoundsErrors = false, kAdvancesBoth = true;
  static constexpr Reading kReading = kAsReleased;

  template <class Predicate>
  static bool negative(const Predicate& predicate) {
    return predicate.value() < 0;
  }
  template <class Predicate>
  static bool redundant(const Predicate& predicate) {
    return predicate.value() <= 0;
  }
  template <class S>
  static S pulled(const S& intercept) {
    return intercept;
  }
  template <class S>
  static void raise(Lines<S>&, const S&) {}
  template <class S>
  static S envelope_error(const Lines<S>&, const CoefficientError&, const S&) {
    return S(0);
  }
  template <class S>
  static bool starts_below(const Line<S>& f, const Line<S>& g, const S& t) {
    return S(f.at(t) + g.at(t)) < 0;
  }
  template <class S>
  static S left_root(const Lines<S>& f, const Lines<S>& g, int i, int j, const TimeWindow<S>&) {
    return root(f[i], g[j]);
  }
  template <class S>
  static S right_root(const Lines<S>& f, const Lines<S>& g, int i, int j, const TimeWindow<S>&) {
    return root(f[i], g[j]);
  }

 private:
  /// Eq. 10.
  template <class S>
  static S root(const Line<S>& f, const Line<S>& g) {
    return S(-S(S(f.intercept + g.intercept) / S(f.slope + g.slope)));
  }
};

/// What a line is pulled apart by.
enum class PullUnit : std::uint8_t {
  kIntercept,  ///< a share of its own intercept
  kLength,     ///< the same length for all
};

/// TDIBM-H: Plain on lines that are pulled apart.
struct PullApart : Plain {
  double factor = 0;
  PullUnit unit = PullUnit::kIntercept;

  explicit PullApart(double f, PullUnit u = PullUnit::kIntercept) : factor(f), unit(u) {}
  double pulled(double intercept) const {
    return intercept + factor * (unit == PullUnit::kIntercept ? std::abs(intercept) : 1);
  }
};

/// Which sign eps_Phi takes where Step II pops a line. Fig. 2 and the derivation of Delta_Phi mean
/// Phi ≤ +eps; Sections 4.4 and 4.6 print Phi < −eps.
enum class PopRule { kAsIntended, kAsPrinted };

/// What I of Iδ counts on the way to the pair of lines that cross.
enum class PullCount : std::uint8_t {
  kSteps,  ///< "a total of I = α* + β* steps" (C.3): none if it is the first pair
  kPairs,  ///< "the I-th iteration" (C.3): one more
};

/// TDIBM-E: Section 4.6 with Appendices A–C.
template <PopRule rule>
struct ErrorBound {
  static constexpr bool kBoundsErrors = true, kAdvancesBoth = false;
  static constexpr Reading kReading = kAsInAppendixA;
  /// Section 4.3's machine epsilon, twice the unit roundoff.
  static constexpr double kEpsilon = 0x1p-52;

  /// B·[(1+eps)^k − 1], overestimated as Appendix B does.
  static double bound(double magnitude, int roundings) {
    return 2 * magnitude * roundings * kEpsilon;
  }

  template <class Predicate>
  static bool negative(const Predicate& predicate) {
    return predicate.value() < -bound(predicate.magnitude(), Predicate::kRoundings);
  }
  template <class Predicate>
  static bool redundant(const Predicate& predicate) {
    const double slack = bound(predicate.magnitude(), Predicate::kRoundings);
    return rule == PopRule::kAsIntended ? predicate.value() <= slack : predicate.value() < -slack;
  }
  static double pulled(double intercept) { return intercept; }

  /// eps_constr = eps_coeff + eps_arith (Eqs. 11, 12, 16) on a window that ends at t_hi.
  static double envelope_error(const Lines<double>& sorted, const CoefficientError& error,
                               double t_hi) {
    const auto [lowest, highest] = intercepts_of(sorted);
    const double delta_a = sorted.back().slope - sorted[0].slope;
    const double delta_b = highest - lowest;
    const double worst = std::max(4 * delta_b, t_hi * delta_a + delta_b);
    return (t_hi * error.slope + error.intercept) + sorted.size() * bound(worst, 4);
  }
  static void raise(Lines<double>& envelope, double error) {
    for (int i = 0; i < envelope.size(); ++i) {
      envelope[i].intercept = next_up(envelope[i].intercept + error);
    }
  }

  template <class S>
  static bool starts_below(const Line<S>& f, const Line<S>& g, const S& t) {
    return negative(EndValue<S>{S(f.slope + g.slope), S(f.intercept + g.intercept), t});
  }

  PullCount count = PullCount::kSteps;

  /// Eq. 10 on envelopes pulled apart by I·delta each, where I is the steps taken from the first
  /// pair, or one more. The root is moved inward by eps_tau (C.2) and clamped to the window.
  double left_root(const Lines<double>& f, const Lines<double>& g, int i, int j,
                   const TimeWindow<double>& w) const {
    const Root root = root_of(f, g, i, j, i + j);
    return std::clamp(next_up(root.t + root.error), w.lo, w.hi);
  }
  double right_root(const Lines<double>& f, const Lines<double>& g, int i, int j,
                    const TimeWindow<double>& w) const {
    const Root root = root_of(f, g, i, j, (f.size() - 1 - i) + (g.size() - 1 - j));
    return std::clamp(next_down(root.t - root.error), w.lo, w.hi);
  }

 private:
  struct Root {
    double t, error;
  };

  /// The lowest and the highest.
  static std::array<double, 2> intercepts_of(const Lines<double>& lines) {
    double lowest = lines[0].intercept, highest = lowest;
    for (const Line<double>& line : lines) {
      lowest = std::min(lowest, line.intercept);
      highest = std::max(highest, line.intercept);
    }
    return {lowest, highest};
  }

  Root root_of(const Lines<double>& f, const Lines<double>& g, int i, int j, int steps) const {
    if (count == PullCount::kPairs) ++steps;
    const double pull = steps == 0 ? 0 : steps * delta(f, g);
    const auto pulled_up = [pull](double d) { return next_up(d + pull); };
    const double l = pulled_up(f[i].intercept) + pulled_up(g[j].intercept);
    const double r = f[i].slope + g[j].slope;
    // eps_tau = 2·|l/r|·[(1+eps)² − 1]
    return {-(l / r), bound(2 * std::abs(l / r), 2)};
  }

  /// delta = 2·Delta_d·[(1+eps)⁴ − 1], Delta_d the greatest |d_alpha − d_beta| (Section 4.5).
  static double delta(const Lines<double>& f, const Lines<double>& g) {
    const std::array<double, 2> d = intercepts_of(f), e = intercepts_of(g);
    return bound(2 * std::max(std::abs(d[0] + e[0]), std::abs(d[1] + e[1])), 4);
  }
};

using ErrorBoundIntended = ErrorBound<PopRule::kAsIntended>;
using ErrorBoundPrinted = ErrorBound<PopRule::kAsPrinted>;

}  // namespace ccdfuzz
