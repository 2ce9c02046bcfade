#include "ccd/projection.hpp"
#include "bezier/exact_patch.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "bezier/restrict.hpp"
#include "ccd/sub_patches.hpp"
#include "numeric/products.hpp"
#include "planted.hpp"

namespace ccdfuzz {
namespace {

/// A cell reached by `depth` random splits.
Cell random_cell(Draw& random, const Shape& shape, int depth) {
  Cell cell;
  for (int d = 0; d < depth; ++d) {
    cell = cell.child(
        shape, static_cast<int>(random.below(static_cast<std::uint64_t>(shape.child_count()))));
  }
  return cell;
}

/// A patch whose coordinates fill the mantissa, as exact inputs do not.
MovingPatch<double> full_mantissa_patch(Draw& random, const Shape& shape) {
  MovingPatch<double> patch{shape, {}, {}};
  for (int i = 0; i < shape.control_count(); ++i) {
    for (Points<double>* points : {&patch.positions, &patch.velocities}) {
      Vec3<double> p;
      for (int k = 0; k < 3; ++k) {
        p[k] = std::ldexp(static_cast<double>(random.integer(-(1L << 53), 1L << 53)), -53);
      }
      points->push_back(p);
    }
  }
  return patch;
}

/// The largest errors of the lines of a random sub-patch on each of the axes l1 … l15, in units of
/// the claimed bounds.
Rational worst_share_of_bound(Draw& random, const Shape& shape) {
  Query query;
  for (MovingPatch<double>& patch : query.patches) patch = full_mantissa_patch(random, shape);
  SubPatches parts(kAsInAppendixA.axes);
  parts.begin(query);
  std::array<Cell, 2> cells;
  for (int side = 0; side < 2; ++side) {
    cells[side] = random_cell(random, shape, 5);
    parts.prepare(side, std::span(&cells[side], 1));
  }
  const MovingPatch<Rational> part = restrict_to(exact_patch<Rational>(query.patches[0]),
                                                 exact_corners<Rational>(cells[0].corners(shape)));
  const ObbAxes axes = parts.axes(0, 0, .25);
  Rational worst = 0;
  for (int r = 0; r < ObbAxes::kCount; ++r) {
    const Axis axis = axes[r];
    const CoefficientError bound =
        coefficient_error(shape, largest_components_of(query.patches[0]), axis);
    const ControlNet net = parts.net(0, 0);
    for (size_t i = 0; i < net.positions.size(); ++i) {
      const auto error = [&](const Vec3<double>& rounded, const Vec3<Rational>& exact_point) {
        const Rational height = dot(exact(axis.direction), exact_point);
        return Rational(abs(Rational(exact(dot(axis.direction, rounded)) - height)));
      };
      const Rational position = error(net.positions[i], part.positions[i]);
      const Rational velocity = error(net.velocities[i], part.velocities[i]);
      worst = std::max({worst, Rational(position / exact(bound.intercept)),
                        Rational(velocity / exact(bound.slope))});
    }
  }
  return worst;
}

TEST(Projection, StepOneIsWithinTheBoundsOfAppendixA) {
  for (const Shape& shape :
       {Shape::curve(1), Shape::curve(5), Shape::triangle(1), Shape::triangle(2),
        Shape::triangle(4), Shape::tensor(1, 1), Shape::tensor(3, 2)}) {
    for (int index = 0; index < 5; ++index) {
      Draw random{Random::keyed({6, static_cast<std::uint64_t>(index)})};
      const Rational worst = worst_share_of_bound(random, shape);
      EXPECT_LE(worst, 1) << to_text(shape) << " #" << index;
      EXPECT_GT(worst, 0) << to_text(shape) << " #" << index << ": nothing was rounded";
    }
  }
}

TEST(Projection, BoundsGrowWithPatchAndAxis) {
  const LargestComponents unit_extent{1, 2};
  const Axis first{{1, 0, 0}, 0}, last{{1, 0, 0}, 5};
  const CoefficientError at_first = coefficient_error(Shape::triangle(2), unit_extent, first);
  const CoefficientError at_last = coefficient_error(Shape::triangle(2), unit_extent, last);
  // 2·B·k·eps with B = 3·2²·2^stage and k = 12 + 2·stage + 3.
  EXPECT_EQ(at_first.intercept, 2 * 12 * 15 * 0x1p-52);
  EXPECT_EQ(at_last.intercept, 2 * 384 * 25 * 0x1p-52);
  EXPECT_EQ(at_first.slope, 2 * at_first.intercept);
}

}  // namespace
}  // namespace ccdfuzz
