#include "ccd/axes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "ccd/sub_patches.hpp"
#include "numeric/products.hpp"
#include "random_query.hpp"

namespace ccdfuzz {
namespace {

constexpr AxisReading kUnitAxes{AxisReading::Spans::kCorners, AxisReading::Length::kUnit};

/// l_1 … l_15, without those that are zero.
std::vector<Axis> axes_of(const Query& query, const AxisReading& reading = kUnitAxes) {
  SubPatches whole(reading);
  whole.begin(query);
  for (int side = 0; side < 2; ++side) whole.prepare(side, std::array{Cell()});
  const ObbAxes all = whole.axes(0, 0, .25);
  std::vector<Axis> axes;
  for (int r = 0; r < ObbAxes::kCount; ++r) {
    if (!all[r].is_zero()) axes.push_back(all[r]);
  }
  return axes;
}

double length(const Vec3<double>& v) {
  return std::sqrt(dot(v, v));
}

/// Divisions, products, sums and a square root, all of numbers near 1.
constexpr double kFewRoundings = 8 * 0x1p-53;

TEST(Axes, SurfacesHaveAllFifteenOfUnitLength) {
  const std::vector<Axis> axes = axes_of(random_query(Shape::triangle(2), Shape::tensor(3, 2), 1));
  ASSERT_EQ(axes.size(), 15u);
  const std::array<int, 15> stages = {0, 1, 2, 0, 1, 2, 1, 2, 3, 2, 3, 4, 3, 4, 5};
  for (size_t r = 0; r < 15; ++r) {
    EXPECT_NEAR(length(axes[r].direction), 1, kFewRoundings) << "l_" << r + 1;
    EXPECT_EQ(axes[r].stage, stages[r]) << "l_" << r + 1;
  }
}

TEST(Axes, ADirectionWithANaNIsZeroWhereverTheNaNStands) {
  for (int k = 0; k < 3; ++k) {
    Vec3<double> end{1, 1, 1};
    end[k] = std::nan("");
    const std::array<Vec3<double>, 2> positions = {Vec3<double>(0, 0, 0), end}, at_rest{};
    const Frame frame = obb_frame({Shape::curve(1), positions, at_rest}, 0, kUnitAxes, 0);
    EXPECT_TRUE(is_zero(frame)) << "component " << k;
  }
}

/// The axes of a reading and those of unit length point the same way, up to a few roundings.
void expect_same_directions(const std::vector<Axis>& axes, const std::vector<Axis>& unit) {
  ASSERT_EQ(axes.size(), unit.size());
  for (size_t r = 0; r < axes.size(); ++r) {
    const double cosine = dot(axes[r].direction, unit[r].direction) / length(axes[r].direction);
    EXPECT_NEAR(std::abs(cosine), 1, 0x1p-40) << "l_" << r + 1;
  }
}

TEST(Axes, AppendixANormalisesTheSpansAlone) {
  const Query query = random_query(Shape::triangle(2), Shape::triangle(3), 1);
  const std::vector<Axis> axes = axes_of(query, kAsInAppendixA.axes);
  expect_same_directions(axes, axes_of(query));
  for (const size_t span : {0, 3}) EXPECT_NEAR(length(axes[span].direction), 1, kFewRoundings);
  for (const size_t product : {1, 2, 4, 5, 6, 8, 14}) {
    EXPECT_LT(length(axes[product].direction), 1 - 0x1p-20) << "l_" << product + 1;
  }
}

TEST(Axes, ReleasedOnesAreTheSpansAndTheirProductsAsTheyAre) {
  const Query query = random_query(Shape::triangle(2), Shape::triangle(3), 1);
  const std::vector<Axis> axes = axes_of(query, kAsReleased.axes);
  expect_same_directions(axes, axes_of(query));
  const MovingPatch<double>& patch = query.patches[0];
  const Points<double> at = patch.at(.25);
  const Vec3<double> u = at[5] - at[0], v = at[2] - at[0];  // order w², vw, v², uw, uv, u²
  EXPECT_NEAR(length(axes[0].direction), length(u), 0x1p-40 * length(u));
  EXPECT_NEAR(length(axes[1].direction), length(cross(u, v)), 0x1p-40 * length(u) * length(v));
}

TEST(Axes, ReleasedSpansOfARectangleAreThoseOfBothItsSides) {
  const Query query = random_query(Shape::tensor(2, 1), Shape::triangle(1), 1);
  const Points<double> at = query.patches[0].at(.25);
  const Vec3<double> u = (at[4] - at[0]) + (at[5] - at[1]);
  for (const AxisReading& reading : {kAsReleased.axes, kTraditionalAsReleased}) {
    const Vec3<double> l = axes_of(query, reading)[0].direction;
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(l[k], u[k], 0x1p-40 * length(u));
  }
}

TEST(Axes, TheSlipMovesTheVSpanOfTheSecondPatchAsU) {
  const Query query = random_query(Shape::triangle(1), Shape::triangle(1), 2);
  AxisReading slip = kAsReleased.axes;
  slip.spans = AxisReading::Spans::kSidesWithSlip;
  const std::vector<Axis> axes = axes_of(query, slip), right = axes_of(query, kAsReleased.axes);
  for (const size_t r : {0, 1, 2, 3}) EXPECT_EQ(axes[r].direction, right[r].direction);
  const MovingPatch<double>& patch = query.patches[1];
  const Vec3<double> u = right[3].direction;
  const Vec3<double> v =
      (patch.positions[1] - patch.positions[0]) + .25 * (patch.velocities[2] - patch.velocities[0]);
  EXPECT_EQ(axes[4].direction, cross(u, v));
  EXPECT_NE(axes[4].direction, right[4].direction);
}

TEST(Axes, FirstAxisIsTheSpanAtTheGivenTime) {
  const Query query = random_query(Shape::triangle(1), Shape::triangle(1), 2);
  const MovingPatch<double>& patch = query.patches[0];
  Vec3<double> span;
  for (int k = 0; k < 3; ++k) {
    span[k] = patch.at(.25)[2][k] - patch.at(.25)[0][k];  // order w, v, u
  }
  const std::vector<Axis> axes = axes_of(query);
  for (int k = 0; k < 3; ++k) {
    EXPECT_NEAR(axes[0].direction[k], span[k] / length(span), kFewRoundings);
  }
}

TEST(Axes, FramesAreOrthogonal) {
  const std::vector<Axis> axes = axes_of(random_query(Shape::triangle(2), Shape::curve(2), 3u));
  ASSERT_EQ(axes.size(), 15u);
  for (const size_t first : {0, 3}) {
    for (size_t i = 0; i < 3; ++i) {
      for (size_t j = 0; j < i; ++j) {
        EXPECT_NEAR(dot(axes[first + i].direction, axes[first + j].direction), 0, 0x1p-48);
      }
    }
  }
}

TEST(Axes, PointsAddNoneOfTheirOwn) {
  EXPECT_EQ(axes_of(random_query(Shape::point(), Shape::triangle(2), 4)).size(), 3u);
  EXPECT_EQ(axes_of(random_query(Shape::point(), Shape::curve(2), 5)).size(), 3u);
  EXPECT_EQ(axes_of(random_query(Shape::point(), Shape::point(), 6)).size(), 3u);
}

TEST(Axes, DegenerateSpansAreSkipped) {
  Query query = random_query(Shape::triangle(1), Shape::triangle(1), 7);
  query.patches[0].positions.assign(3, query.patches[0].positions[0]);
  query.patches[0].velocities.assign(3, query.patches[0].velocities[0]);
  EXPECT_EQ(axes_of(query).size(), 3u) << "patch 1 is a point in motion";
  query.patches[1].positions.assign(3, query.patches[1].positions[0]);
  query.patches[1].velocities.assign(3, query.patches[1].velocities[0]);
  EXPECT_EQ(axes_of(query).size(), 0u) << "as in the paper: nothing separates";
}

TEST(Axes, ScaleDoesNotMatter) {
  for (const int exponent : {-1000, -600, 600, 900}) {
    Query query = random_query(Shape::triangle(2), Shape::triangle(2), 8);
    const std::vector<Axis> reference = axes_of(query);
    for (MovingPatch<double>& patch : query.patches) {
      for_each_coordinate(patch, [&](double& x) { x = std::ldexp(x, exponent); });
    }
    const std::vector<Axis> scaled = axes_of(query);
    ASSERT_EQ(scaled.size(), reference.size());
    for (size_t r = 0; r < scaled.size(); ++r) {
      EXPECT_EQ(scaled[r].direction, reference[r].direction) << exponent;
    }
  }
}

}  // namespace
}  // namespace ccdfuzz
