#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "bezier/exact_patch.hpp"
#include "bezier/random_patch.hpp"
#include "bezier/restrict.hpp"
#include "ccd/certified/cell_tree.hpp"
#include "ccd/certified/midpoint_program.hpp"
#include "ccd/certified/normalise.hpp"
#include "ccd/certified/window_trim.hpp"

namespace ccdfuzz::certified {
namespace {

/// A double with all its bits in use and an exponent near `exponent`.
double any_double(int exponent) {
  const auto whole = rc::gen::resize(rc::kNominalSize, rc::gen::arbitrary<std::int64_t>());
  const double mantissa = static_cast<double>(*whole);
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

/// The same with two positions of each point, and with weights, of a chance of one in two each.
void give_ends_or_weights(MovingPatch<double>& patch) {
  if (*rc::gen::arbitrary<bool>()) {
    patch.ends = std::exchange(patch.velocities, {});
    for (size_t i = 0; i < patch.ends.size(); ++i) patch.ends[i] += patch.positions[i];
  }
  if (*rc::gen::arbitrary<bool>()) {
    for (size_t i = 0; i < patch.positions.size(); ++i) {
      patch.weights.push_back(std::ldexp(std::abs(any_double(0)) + 1, *rc::gen::inRange(-30, 30)));
    }
  }
}

std::string describe(const Query& query) {
  std::string text = fmt::format("t_max {:a}", query.t_max);
  for (const auto& patch : query.patches) {
    text += fmt::format("\n{}", to_text(patch.shape));
    for (size_t i = 0; i < patch.positions.size(); ++i) {
      const Vec3<double>&p = patch.positions[i], &v = patch.moves()[i];
      text += fmt::format("\n  {:a} {:a} {:a}  {} {:a} {:a} {:a}", p[0], p[1], p[2],
                          patch.has_ends() ? "end" : "v", v[0], v[1], v[2]);
      if (!patch.weights.empty()) text += fmt::format("  w {:a}", patch.weights[i]);
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

TEST(MidpointProgram, CountsTheRoundingsBehindEverySlot) {
  for (int n = 1; n <= kMaxDegree; ++n) {
    for (const Shape& shape : {Shape::curve(n), Shape::triangle(n), Shape::tensor(n, 3)}) {
      const MidpointProgram program(shape);
      std::vector<int> behind(shape.control_count(), 0);
      for (const MidpointProgram::Step s : program.steps) {
        behind.push_back(std::max(behind[s.left], behind[s.right]) + 1);
      }
      EXPECT_EQ(*std::max_element(behind.begin(), behind.end()), program.roundings)
          << to_text(shape);
    }
  }
}

/// The claim of DERIVATION.md, 3: a computed gap differs from the exact one by at most E.
RC_GTEST_PROP(LawC, TheBoundCoversEveryRoundingOfAGap, ()) {
  const int exponent = *rc::gen::element(0, 0, 0, -1070, -1040, -600, 500, 1018);
  const double translation = *rc::gen::element(0.0, 1.0, 0x1p20, 0x1p40) *
                             std::ldexp(1.0, exponent > 900 ? 900 : exponent);
  Query query;
  query.patches = {any_full_patch(exponent, translation), any_full_patch(exponent, translation)};
  for (MovingPatch<double>& patch : query.patches) give_ends_or_weights(patch);
  query.t_max = std::abs(any_double(0));
  RC_PRE(query.t_max > 0);

  NormalisedQuery n;
  normalise(query, n);
  CellTree trees[2];
  CellTree::Node nodes[2] = {0, 0};
  const int depth = *rc::gen::inRange(0, 12);
  for (int s = 0; s < 2; ++s) {
    trees[s].reset(n.shapes[s], n.controls[s], n.weights[s]);
    for (int d = 0; d < depth; ++d) {
      const int c = *rc::gen::inRange(0, n.shapes[s].child_count());
      nodes[s] = trees[s].children(nodes[s]) + static_cast<CellTree::Node>(c);
    }
  }
  const Axis l = {any_double(0), any_double(0), any_double(-3)};
  const double t = n.t_max * std::ldexp(*rc::gen::inRange(0, 1025), -10);
  const HeightErrorBound bound(
      n.magnitude, n.absolute,
      n.roundings + std::max(trees[0].roundings(depth), trees[1].roundings(depth)));
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
  const Gaps by_points = gaps_of(ranges[0], ranges[1], 0);
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

/// Two patches at the ends of a window, on an axis.
struct SeenAtEnds {
  Query query;
  Axis l{};
  NormalisedQuery normalised;
  Window window;
  std::array<RangeBatch, 2> ranges;
  SeparatingAxes separating;
  double bound = 0;

  Gaps gaps() const { return gaps_of(ranges[0], ranges[1], 0); }
  /// At `share` of a part of the window, exactly.
  bool are_apart(const Window& part, double share) const {
    const Rational t = exact(part.lo) + (exact(part.hi) - exact(part.lo)) * exact(share);
    const Rational time = t * power_of_two(normalised.time);
    const auto a = exact_extremes(query.patches[0], Cell{}, l, time);
    const auto b = exact_extremes(query.patches[1], Cell{}, l, time);
    return a.second < b.first || b.second < a.first;
  }
};

/// So far apart along the axis at 0, and moved towards each other by so much.
SeenAtEnds any_seen_at_ends(double apart, double approach) {
  SeenAtEnds seen;
  seen.query.patches = {any_full_patch(0, 0), any_full_patch(0, 0)};
  for (double& x : seen.l) x = any_double(0);
  MovingPatch<double>& second = seen.query.patches[1];
  for (size_t i = 0; i < second.positions.size(); ++i) {
    for (int k = 0; k < 3; ++k) {
      const double side = seen.l[static_cast<size_t>(k)] < 0 ? -1 : 1;
      second.positions[i][k] += apart * side;
      second.velocities[i][k] -= approach * side;
    }
  }
  NormalisedQuery& n = seen.normalised;
  normalise(seen.query, n);
  seen.window = {n.t_max * std::ldexp(*rc::gen::inRange(0, 512), -10),
                 n.t_max * std::ldexp(*rc::gen::inRange(512, 1025), -10)};
  AxisBatch batch;
  for (size_t k = 0; k < 3; ++k) batch.axes[k].fill(seen.l[k]);
  const HeightErrorBound error(n.magnitude, n.absolute, 0);
  std::array<CellTree, 2> trees;
  alignas(32) std::array<double, kPerPoint * kMaxControls> values[2];
  std::array<Snapshot, 2> nets;
  for (size_t s = 0; s < 2; ++s) {
    trees[s].reset(n.shapes[s], n.controls[s]);
    take_snapshot(trees[s].net(0), trees[s].count(), seen.window.lo, seen.window.hi,
                  values[s].data());
    nets[s] = {values[s].data(), trees[s].count(), {seen.window, 0}};
  }
  seen.separating =
      project_and_compare(nets[0], nets[1], batch, error.for_axes(batch), seen.ranges);
  seen.bound = error.for_axis(seen.l);
  return seen;
}

/// What two extents at both ends of a window prove, holds at every time between.
RC_GTEST_PROP(LawA, SeparatedAtBothEndsIsSeparatedBetween, ()) {
  const SeenAtEnds seen = any_seen_at_ends(*rc::gen::element(-2.0, -0.5, 0.5, 2.0), 0);
  const bool separated = seen.gaps().separated(seen.bound);
  RC_ASSERT(separated == (seen.separating.throughout != 0));
  RC_CLASSIFY(separated);
  if (!separated) return;
  RC_ASSERT(seen.are_apart(seen.window, std::ldexp(*rc::gen::inRange(0, 1025), -10)));
}

/// What the chords of both ends drop.
RC_GTEST_PROP(LawB, WhatTheChordsDropIsSeparated, ()) {
  // Some pass each other in the window, and some overlap at its end.
  const double side = *rc::gen::element(-1, 1);
  const double approach =
      std::ldexp(*rc::gen::resize(rc::kNominalSize, rc::gen::inRange(4, 24)), -3);
  const SeenAtEnds seen = any_seen_at_ends(side, approach * side);
  const Gaps gaps = seen.gaps();
  Window left = seen.window;
  if (!gaps.separated(seen.bound)) trim_by_chord(gaps, seen.bound, left);
  RC_CLASSIFY(left.lo > seen.window.lo, "from the start");
  RC_CLASSIFY(left.hi < seen.window.hi, "to the end");
  // From the end of the window on, up to but without the end of what is left.
  const double share = std::ldexp(*rc::gen::inRange(0, 1024), -10);
  if (left.lo > seen.window.lo) RC_ASSERT(seen.are_apart({seen.window.lo, left.lo}, share));
  if (left.hi < seen.window.hi) RC_ASSERT(seen.are_apart({seen.window.hi, left.hi}, share));
}

/// Four numbers are read and written at once, of which only the first is where a double may be.
TEST(Kernels, TakeNumbersAtEveryMultipleOfEightBytes) {
  struct alignas(32) {
    double before = 0;
    std::array<double, kPerPoint> net{};
    Bounds bounds{};
  } at;
  const Snapshot snapshot{at.net.data(), 1};
  take_snapshot(at.net.data(), 1, 0, 1, at.net.data());
  std::array<RangeBatch, 2> ranges{};
  EXPECT_EQ(project_and_compare(snapshot, snapshot, {}, at.bounds, ranges).throughout, 0U);
  EXPECT_EQ(not_separated(ranges.data(), ranges.data(), 1, at.bounds), 1U);
}

}  // namespace
}  // namespace ccdfuzz::certified
