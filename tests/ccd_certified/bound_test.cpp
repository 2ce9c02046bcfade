#include <fmt/format.h>

#include <cmath>

#include "bezier/exact_patch.hpp"
#include "bezier/random_patch.hpp"
#include "bezier/restrict.hpp"
#include "ccd/certified/cell_tree.hpp"
#include "ccd/certified/normalise.hpp"
#include "ccd/certified/window_trim.hpp"

namespace ccdfuzz::certified {
namespace {

/// A double with all its bits in use and an exponent near `exponent`.
double any_double(int exponent) {
  const double mantissa = static_cast<double>(*rc::gen::arbitrary<std::int64_t>());
  return std::ldexp(mantissa, exponent - 63 + *rc::gen::inRange(-6, 1));
}

MovingPatch<double> any_full_patch(int exponent, double translation) {
  const Shape shape = *any_shape(3);
  MovingPatch<double> patch{shape, {}, {}};
  for (int i = 0; i < shape.control_count(); ++i) {
    Vec3<double> p, v;
    for (int k = 0; k < 3; ++k) {
      p[k] = translation + any_double(exponent);
      v[k] = any_double(exponent);
    }
    patch.positions.push_back(p);
    patch.velocities.push_back(v);
  }
  return patch;
}

std::string describe(const Query& query) {
  std::string text = fmt::format("t_max {:a}", query.t_max);
  for (const auto& patch : query.patches) {
    text += fmt::format("\n{}", to_text(patch.shape));
    for (size_t i = 0; i < patch.positions.size(); ++i) {
      const Vec3<double>&p = patch.positions[i], &v = patch.velocities[i];
      text +=
          fmt::format("\n  {:a} {:a} {:a}  v {:a} {:a} {:a}", p[0], p[1], p[2], v[0], v[1], v[2]);
    }
  }
  return text;
}

/// Exact extremes of l·(p + t·v) over a sub-patch of the original query, in the units of the
/// normalised one but without its common motion.
std::pair<Rational, Rational> exact_extremes(const MovingPatch<double>& patch, const Cell& cell,
                                             const Axis& l, const Rational& t) {
  const auto part =
      restrict_to(exact_patch<Rational>(patch), exact_corners<Rational>(cell.corners(patch.shape)));
  Rational lowest, highest;
  bool first = true;
  for (const Vec3<Rational>& p : part.at(t)) {
    const Rational x = exact(l[0]) * p[0] + exact(l[1]) * p[1] + exact(l[2]) * p[2];
    if (first || x < lowest) lowest = x;
    if (first || x > highest) highest = x;
    first = false;
  }
  return {lowest, highest};
}

/// The claim of DERIVATION.md, 3: a computed gap differs from the exact one by at most E.
RC_GTEST_PROP(LawC, TheBoundCoversEveryRoundingOfAGap, ()) {
  const int exponent = *rc::gen::element(0, 0, 0, -1070, -1040, -600, 500, 1018);
  const double translation = *rc::gen::element(0.0, 1.0, 0x1p20, 0x1p40) *
                             std::ldexp(1.0, exponent > 900 ? 900 : exponent);
  Query query;
  query.patches = {any_full_patch(exponent, translation), any_full_patch(exponent, translation)};
  query.t_max = std::abs(any_double(0));
  RC_PRE(query.t_max > 0);

  NormalisedQuery n;
  normalise(query, n);
  CellTree trees[2];
  CellTree::Node nodes[2] = {0, 0};
  const int depth = *rc::gen::inRange(0, 12);
  for (int s = 0; s < 2; ++s) {
    trees[s].reset(n.shapes[s], n.controls[s]);
    for (int d = 0; d < depth; ++d) {
      const int c = *rc::gen::inRange(0, n.shapes[s].child_count());
      nodes[s] = trees[s].children(nodes[s]) + static_cast<CellTree::Node>(c);
    }
  }
  const Axis l = {any_double(0), any_double(0), any_double(-3)};
  const double t = n.t_max * std::ldexp(*rc::gen::inRange(0, 1025), -10);
  const HeightErrorBound bound(n.magnitude, n.absolute,
                               std::max(trees[0].roundings(depth), trees[1].roundings(depth)));
  // Heights of the points at t, and of the lines at t: both orders of operations.
  alignas(32) std::array<double, kPerPoint * kMaxControls> values[2];
  RangeBatch ranges[2];
  AxisBatch batch;
  for (int k = 0; k < 3; ++k) batch.axes[k].fill(l[k]);
  for (int s = 0; s < 2; ++s) {
    const int count = trees[s].count();
    take_snapshot(trees[s].net(nodes[s]), count, t, t, values[s].data());
    project({values[s].data(), count}, batch, ranges[s]);
  }
  const Gaps by_points(lane(ranges[0], 0), lane(ranges[1], 0));
  const HeightLines by_lines(
      {{trees[0].net(nodes[0]), trees[1].net(nodes[1])}, {trees[0].count(), trees[1].count()}}, l);

  // The exact gap, brought to the normalised scale by the power of two that normalise used.
  const Rational time = exact(t) * power_of_two(n.time);
  const auto ea = exact_extremes(query.patches[0], trees[0].cell(nodes[0]), l, time);
  const auto eb = exact_extremes(query.patches[1], trees[1].cell(nodes[1]), l, time);
  const Rational scale = power_of_two(n.space);
  const Rational e = exact(bound.for_axis(l));
  RC_LOG() << fmt::format("{}\nt' {:a} axis {:a} {:a} {:a}, E {:a}", describe(query), t, l[0], l[1],
                          l[2], e.get_d())
           << std::endl;
  for (const auto& [computed, exact_gap] :
       {std::pair<std::array<double, 2>, Rational>{{by_points.at_lo[0], by_lines.gap(0, t).height},
                                                   (ea.second - eb.first) * scale},
        std::pair<std::array<double, 2>, Rational>{{by_points.at_lo[1], by_lines.gap(1, t).height},
                                                   (eb.second - ea.first) * scale}}) {
    for (const double gap : computed) RC_ASSERT(abs(exact(gap) - exact_gap) <= e);
  }
}

/// What two extents at both ends of a window prove, holds at every time between.
RC_GTEST_PROP(LawA, SeparatedAtBothEndsIsSeparatedBetween, ()) {
  Query query;
  query.patches = {any_full_patch(0, 0), any_full_patch(0, 0)};
  const Axis l = {any_double(0), any_double(0), any_double(0)};
  const double apart = *rc::gen::element(-8.0, -2.0, 2.0, 8.0);
  for (Vec3<double>& p : query.patches[1].positions) {
    for (int k = 0; k < 3; ++k) p[k] += apart * (l[static_cast<size_t>(k)] < 0 ? -1 : 1);
  }
  NormalisedQuery n;
  normalise(query, n);
  const Window w{n.t_max * std::ldexp(*rc::gen::inRange(0, 512), -10),
                 n.t_max * std::ldexp(*rc::gen::inRange(512, 1025), -10)};
  AxisBatch batch;
  for (size_t k = 0; k < 3; ++k) batch.axes[k].fill(l[k]);
  const HeightErrorBound error(n.magnitude, n.absolute, 0);
  std::array<CellTree, 2> trees;
  alignas(32) std::array<double, kPerPoint * kMaxControls> values[2];
  std::array<Snapshot, 2> nets;
  for (size_t s = 0; s < 2; ++s) {
    trees[s].reset(n.shapes[s], n.controls[s]);
    take_snapshot(trees[s].net(0), trees[s].count(), w.lo, w.hi, values[s].data());
    nets[s] = {values[s].data(), trees[s].count(), {w, 0}};
  }
  std::array<RangeBatch, 2> ranges;
  const SeparatingAxes found =
      project_and_compare(nets[0], nets[1], batch, error.for_axes(batch), ranges);
  const bool separated = Gaps(lane(ranges[0], 0), lane(ranges[1], 0)).separated(error.for_axis(l));
  RC_ASSERT(separated == (found.throughout != 0));
  RC_CLASSIFY(separated);
  if (!separated) return;
  const double t = w.lo + (w.hi - w.lo) * std::ldexp(*rc::gen::inRange(0, 1025), -10);
  const Rational time = exact(t) * power_of_two(n.time);
  const auto a = exact_extremes(query.patches[0], Cell{}, l, time);
  const auto b = exact_extremes(query.patches[1], Cell{}, l, time);
  RC_ASSERT(a.second < b.first || b.second < a.first);
}

}  // namespace
}  // namespace ccdfuzz::certified
