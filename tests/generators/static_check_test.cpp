#include "generators/paper.hpp"

#include <gtest/gtest.h>

namespace ccdfuzz {
namespace {

/// a x² + b xy + c y² + d x + e y
struct Height {
  int a = 0, b = 0, c = 0, d = 0, e = 0;
};

struct Placed {
  Points<Dyadic> points;
  Barycentric x;  ///< where (0, 0, 0) is on it
};

/// The patch (p, q, height(p, q)) over a plane triangle: its control points are the polar form at
/// pairs of corners.
Points<Dyadic> graph(const std::array<std::array<int, 2>, 3>& corner, const Height& h) {
  Points<Dyadic> points;
  for (const auto& [i, j] : kCornerPairs) {
    const auto [x, y] = corner[i];
    const auto [p, q] = corner[j];
    const int twice =
        2 * h.a * x * p + h.b * (x * q + p * y) + 2 * h.c * y * q + h.d * (x + p) + h.e * (y + q);
    points.push_back({Dyadic(x + p, -1), Dyadic(y + q, -1), Dyadic(twice, -1)});
  }
  return points;
}

const Dyadic kZero, kQuarter(1, -2), kHalf(1, -1), kOne(1);

Placed face(const Height& h) {
  return {graph({{{2, 0}, {0, 2}, {-1, -1}}}, h), {kQuarter, kQuarter, kHalf}};
}
/// The same surfaces on another, larger triangle: the parameters of the two faces must not matter.
Placed other_face(const Height& h) {
  return {graph({{{-1, -1}, {8, 4}, {-6, -2}}}, h), {kHalf, kQuarter, kQuarter}};
}
/// An edge along the x axis, with the patch at y ≥ 0.
Placed edge_along_x(const Height& h) {
  return {graph({{{3, 0}, {-3, 0}, {1, 3}}}, h), {kHalf, kHalf, kZero}};
}
/// An edge along the y axis, with the patch at x ≥ 0.
Placed edge_along_y(const Height& h) {
  return {graph({{{2, 1}, {0, 2}, {0, -2}}}, h), {kZero, kHalf, kHalf}};
}
/// A corner with edges along (1, 0) and (0, 1).
Placed corner(const Height& h) {
  return {graph({{{0, 2}, {0, 0}, {2, 0}}}, h), {kZero, kOne, kZero}};
}

/// +1 if patch 1 is found above patch 2 (in z), −1 if below, 0 if the check refuses.
int side(const Placed& one, const Placed& two) {
  const auto normal = static_check({one.points, two.points}, {one.x, two.x});
  return normal ? (*normal)[2].sign() : 0;
}

TEST(StaticCheck, FacesWhoseRelativeFormIsDefinitePass) {
  const Height flat, bowl{1, 0, 1}, steep_bowl{2, 1, 2}, dome{-1, 1, -1};
  EXPECT_EQ(side(face(bowl), other_face(flat)), 1);
  EXPECT_EQ(side(face(flat), other_face(bowl)), -1);
  EXPECT_EQ(side(face(dome), other_face(bowl)), -1);
  EXPECT_EQ(side(face(steep_bowl), other_face(bowl)), 1) << "one bowl inside the other";
  EXPECT_EQ(side(face(bowl), other_face(steep_bowl)), -1);
}

// What Appendix D is there for.
TEST(StaticCheck, FacesWhoseRelativeFormIsASaddleAreRefused) {
  const Height flat, saddle{1, 0, -1}, twisted{1, 3, 1};
  EXPECT_EQ(side(face(saddle), other_face(flat)), 0);
  EXPECT_EQ(side(face(twisted), other_face(flat)), 0);
  EXPECT_EQ(side(face({2, 0, 1}), other_face({1, 0, 2})), 0) << "both bowls, crossing";
}

TEST(StaticCheck, FacesThatSecondOrderDoesNotTellApartAreRefused) {
  EXPECT_EQ(side(face({1, 0, 0}), other_face({})), 0) << "a cylinder on a plane";
  EXPECT_EQ(side(face({}), other_face({})), 0);
}

TEST(StaticCheck, AnEdgeMustCurveToTheSideToWhichThePatchLeavesIt) {
  const Height flat;
  EXPECT_EQ(side(edge_along_x({1, 0, 0, 0, 1}), face(flat)), 1);
  EXPECT_EQ(side(edge_along_x({-1, 0, 0, 0, -1}), face(flat)), -1);
  EXPECT_EQ(side(edge_along_x({-1, 0, 0, 0, 1}), face(flat)), 0);
  EXPECT_EQ(side(edge_along_x({1, 0, 0, 0, -1}), face(flat)), 0);
  EXPECT_EQ(side(edge_along_x({0, 0, 0, 0, 1}), face(flat)), 0) << "a straight edge lies in it";
  EXPECT_EQ(side(edge_along_x({1, 0, 0, 0, 0}), face(flat)), 0) << "tangent patch";
}

TEST(StaticCheck, TheFaceUnderAnEdgeMayCurveTooAlongTheEdgeOnly) {
  EXPECT_EQ(side(edge_along_x({1, 0, 0, 0, 1}), face({2, 0, 0})), 0);
  EXPECT_EQ(side(edge_along_x({3, 0, 0, 0, 1}), face({2, 0, 0})), 1);
  EXPECT_EQ(side(edge_along_x({1, 0, 0, 0, 1}), face({0, 0, 9})), 1) << "across does not matter";
}

TEST(StaticCheck, ACornerOnAFaceNeedsBothEdgesOnOneSide) {
  EXPECT_EQ(side(corner({0, 0, 0, 1, 1}), face({})), 1);
  EXPECT_EQ(side(corner({0, 0, 0, -1, -2}), face({})), -1);
  EXPECT_EQ(side(corner({0, 0, 0, 1, -1}), face({})), 0);
  EXPECT_EQ(side(corner({0, 0, 0, 1, 0}), face({})), 0);
}

TEST(StaticCheck, CrossingEdgesNeedTheirPatchesOnOppositeSides) {
  const Height up_from_x{0, 0, 0, 0, 1}, up_from_y{0, 0, 0, 1, 0};
  const Height down_from_x{0, 0, 0, 0, -1}, down_from_y{0, 0, 0, -1, 0};
  EXPECT_EQ(side(edge_along_x(up_from_x), edge_along_y(down_from_y)), 1);
  EXPECT_EQ(side(edge_along_x(down_from_x), edge_along_y(up_from_y)), -1);
  EXPECT_EQ(side(edge_along_x(up_from_x), edge_along_y(up_from_y)), 0);
}

TEST(StaticCheck, CornersOnEdgesAndCornersNeedASeparatingPlane) {
  const Height up{0, 0, 0, 1, 1}, down{0, 0, 0, -1, -1};
  EXPECT_EQ(side(corner(up), edge_along_y({0, 0, 0, -1, 0})), 1);
  EXPECT_EQ(side(corner(up), corner(down)), 1);
  EXPECT_EQ(side(corner(down), corner(up)), -1);
  EXPECT_EQ(side(corner({0, 0, 0, 1, -1}), corner({0, 0, 0, -1, 1})), 0) << "crossing wedges";
}

}  // namespace
}  // namespace ccdfuzz
