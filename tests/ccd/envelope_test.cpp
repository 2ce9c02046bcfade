#include "ccd/envelope.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "line_families.hpp"

namespace ccdfuzz {
namespace {

constexpr int kEnvelopeProblems = 5'000;

LineProblem envelope_problem(int index) {
  Draw random{Random::keyed({5, static_cast<std::uint64_t>(index)})};
  return index % 2 == 0 ? concurrent_lines(random) : shielded_lines(random);
}

Rational maximum_at(const Lines<Rational>& lines, const Rational& t) {
  Rational highest = lines[0].at(t);
  for (const Line<Rational>& line : lines) highest = std::max(highest, line.at(t));
  return highest;
}

/// The ends of w and every time in it at which two of the lines cross: where the difference of two
/// maxima of such lines has its extremes.
std::vector<Rational> critical_times(const Lines<Rational>& lines, const TimeWindow<Rational>& w) {
  std::vector<Rational> times = {w.lo, w.hi};
  for (const Line<Rational>& x : lines) {
    for (const Line<Rational>& y : lines) {
      if (x.slope == y.slope) continue;
      const Rational t((y.intercept - x.intercept) / (x.slope - y.slope));
      if (w.lo <= t && t <= w.hi) times.push_back(t);
    }
  }
  return times;
}

TEST(Envelope, IsTheMaximumInExactArithmetic) {
  for (int i = 0; i < kEnvelopeProblems; ++i) {
    const LineProblem p = envelope_problem(i);
    const Lines<Rational> lines = exact(p.f);
    Lines<Rational> envelope;
    upper_envelope(Plain(), lines, exact(p.w), envelope);
    for (const Rational& t : critical_times(lines, exact(p.w))) {
      ASSERT_EQ(maximum_at(envelope, t), maximum_at(lines, t)) << to_text(p);
    }
  }
}

/// In order of time, each line the maximum somewhere: slopes rise, and so do the turning points.
TEST(Envelope, IsAConvexChainInExactArithmetic) {
  for (int i = 0; i < kEnvelopeProblems; ++i) {
    const LineProblem p = envelope_problem(i);
    const TimeWindow<Rational> w = exact(p.w);
    Lines<Rational> envelope;
    upper_envelope(Plain(), exact(p.f), w, envelope);
    Rational turn = w.lo;
    for (int k = 1; k < envelope.size(); ++k) {
      const Line<Rational>&a = envelope[k - 1], &b = envelope[k];
      ASSERT_LT(a.slope, b.slope) << to_text(p);
      const Rational next((a.intercept - b.intercept) / (b.slope - a.slope));
      ASSERT_LT(turn, next) << to_text(p);
      turn = next;
    }
    ASSERT_TRUE(envelope.size() == 1 || turn < w.hi) << to_text(p);
  }
}

TEST(Envelope, NeverBelowExactMaxOnceRaisedByTheErrorBound) {
  const ErrorBoundIntended policy;
  for (int i = 0; i < kEnvelopeProblems; ++i) {
    const LineProblem p = envelope_problem(i);
    Lines<double> envelope;
    upper_envelope(policy, p.f, p.w, envelope);
    policy.raise(envelope, policy.envelope_error(p.f, {}, p.w.hi));
    const Lines<Rational> lines = exact(p.f), raised = exact(envelope);
    Lines<Rational> all = lines;
    for (const Line<Rational>& line : raised) all.push_back(line);
    for (const Rational& t : critical_times(all, exact(p.w))) {
      ASSERT_GE(maximum_at(raised, t), maximum_at(lines, t))
          << to_text(p) << "at t = " << t << ", raised:\n"
          << to_text(envelope);
    }
  }
}

/// Without eps_constr the claim is false, so the test above can fail.
TEST(Envelope, DipsBelowExactMaxBeforeItIsRaised) {
  const ErrorBoundIntended policy;
  int dips = 0;
  for (int i = 0; i < kEnvelopeProblems; ++i) {
    const LineProblem p = envelope_problem(i);
    Lines<double> envelope;
    upper_envelope(policy, p.f, p.w, envelope);
    const Lines<Rational> lines = exact(p.f), selected = exact(envelope);
    for (const Rational& t : critical_times(lines, exact(p.w))) {
      if (maximum_at(selected, t) < maximum_at(lines, t)) ++dips;
    }
  }
  EXPECT_GT(dips, 0);
}

TEST(Lines, SortAscendingInSlopeThenIntercept) {
  Draw random{Random::keyed({1})};
  for (int size = 1; size <= kMaxControls; ++size) {
    Lines<double> lines;
    std::vector<std::pair<double, double>> expected;
    for (int i = 0; i < size; ++i) {
      const double slope = fraction(random, 3);
      const double intercept = fraction(random, 3);
      lines.push_back({slope, intercept});
      expected.emplace_back(slope, intercept);
    }
    std::sort(expected.begin(), expected.end());
    sort_lines(lines);
    for (int i = 0; i < size; ++i) {
      ASSERT_EQ(std::pair(lines[i].slope, lines[i].intercept), expected[static_cast<size_t>(i)])
          << "of " << size;
    }
  }
}

TEST(Lines, NegationIsExactAndStaysSorted) {
  for (int i = 0; i < 100; ++i) {
    const LineProblem p = envelope_problem(i);
    Lines<double> negated, back;
    negate_lines(p.f, negated);
    for (int k = 1; k < negated.size(); ++k) {
      ASSERT_TRUE(negated[k - 1].slope < negated[k].slope ||
                  (negated[k - 1].slope == negated[k].slope &&
                   negated[k - 1].intercept <= negated[k].intercept))
          << to_text(p);
    }
    negate_lines(negated, back);
    ASSERT_EQ(to_text(back), to_text(p.f));
  }
}

}  // namespace
}  // namespace ccdfuzz
