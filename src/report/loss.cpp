#include "report/loss.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <vector>

#include "base/verify.hpp"
#include "bezier/exact_patch.hpp"
#include "bezier/restrict.hpp"
#include "numeric/products.hpp"

namespace ccdfuzz {

namespace {

using Heights = std::ranges::minmax_result<Rational>;

/// The heights of the control points of a part along an axis at an exact time.
Heights heights_at(const MovingPatch<double>& patch, const Cell& cell, const Vec3<double>& axis,
                   const Rational& t) {
  const MovingPatch<Rational> part =
      restrict_to(exact_patch<Rational>(patch), exact_corners<Rational>(cell.corners(patch.shape)));
  std::vector<Rational> heights;
  for (const Vec3<Rational>& p : part.at(t)) heights.push_back(dot(p, exact(axis)));
  return std::ranges::minmax(heights);
}

/// Doubles in (a, b], 0 ≤ a ≤ b.
std::uint64_t doubles_between(double a, double b) {
  return std::bit_cast<std::uint64_t>(b) - std::bit_cast<std::uint64_t>(std::abs(a));
}

/// x / sqrt(squares) as a double, whatever the range of either.
double over_root(const Rational& x, const Rational& squares) {
  mpf_class quotient(x, 256), root(squares, 256);
  quotient /= sqrt(root);
  return quotient.get_d();
}

double ulp_of(double x) {
  return std::nextafter(x, std::numeric_limits<double>::infinity()) - x;
}

std::optional<LossFacts::Overlap> overlap_of(const Query& query, const Witness& witness,
                                             const Trace::Loss& loss) {
  const Vec3<double>& axis = loss.by.direction;
  if (!axis.allFinite() || axis == Vec3<double>(0, 0, 0)) return std::nullopt;
  std::array<Heights, 2> heights;
  for (size_t s = 0; s < 2; ++s) {
    heights[s] = heights_at(query.patches[s], loss.place.cells[s], axis, witness.t);
  }
  const auto below = static_cast<size_t>(loss.by.below);
  const Rational overlap = heights[below].max - heights[1 - below].min;
  const Rational squares = dot(exact(axis), exact(axis));
  Rational largest = 0;
  for (const Heights& h : heights) {
    largest = std::max<Rational>({largest, abs(h.min), abs(h.max)});
  }
  return LossFacts::Overlap{over_root(overlap, squares), ulp_of(over_root(largest, squares))};
}

}  // namespace

LossFacts facts_of(const Query& query, const Witness& witness, const Trace::Loss& loss) {
  CCDFUZZ_VERIFY(loss.by.axis >= 0);
  LossFacts facts;
  facts.overlap = overlap_of(query, witness, loss);
  const SeparatedInterval<double>& times = loss.by.times;
  if (!times.has_lo) facts.ulps_past = doubles_between(times.lo, round_down(witness.t));
  if (!times.has_hi) {
    const std::uint64_t past = doubles_between(round_up(witness.t), times.hi);
    facts.ulps_past = std::min(facts.ulps_past.value_or(past), past);
  }
  return facts;
}

}  // namespace ccdfuzz
