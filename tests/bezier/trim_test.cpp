// Loops that a patch may have, and the closed region that they bound.
#include "bezier/trim.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include "bezier/orientation.hpp"
#include "bezier/trim_region.hpp"

namespace ccdfuzz {
namespace {

constexpr double kTiny = 0x1p-1074;

std::string fault(const Trim& trim, const Shape& shape = Shape::tensor(1, 1)) {
  const auto found = fault_of(trim, shape);
  return found ? found->message() : "";
}

const std::vector<Uv<double>> kOuter = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
const std::vector<Uv<double>> kHole = {{0.25, 0.25}, {0.75, 0.25}, {0.75, 0.75}, {0.25, 0.75}};

TEST(Orientation, IsExactWhereRoundedProductsAreNot) {
  const double third = 1.0 / 3, above = std::nextafter(third, 1);
  EXPECT_EQ(orientation({0, 0}, {third, third}, {1, 1}), 0);
  EXPECT_EQ(orientation({0, 0}, {third, above}, {1, 1}), -1);
  EXPECT_EQ(orientation({0, 0}, {above, third}, {1, 1}), 1);
  EXPECT_EQ(orientation({0, 0}, {1, kTiny}, {1, 0}), -1);
  EXPECT_EQ(orientation({0, 0}, {1, 0}, {kTiny, kTiny}), 1);
  EXPECT_EQ(orientation({kTiny, kTiny}, {1, 1}, {0.5, 0.5}), 0);
}

TEST(Trim, MayTouchAndBeNested) {
  EXPECT_EQ(fault({}), "");
  EXPECT_EQ(fault({kOuter, kHole}), "");
  EXPECT_EQ(fault({kOuter, kHole, {{0.4, 0.4}, {0.6, 0.4}, {0.5, 0.6}}}), "") << "an island";
  EXPECT_EQ(fault({kOuter, kOuter}), "") << "along all edges";
  EXPECT_EQ(fault({kHole, {{0.25, 0.5}, {0, 0}, {0, 1}}}), "") << "a vertex on an edge";
  EXPECT_EQ(fault({kHole, {{0.25, 0.25}, {0, 0}, {0.25, 0}}}), "") << "at vertices";
  EXPECT_EQ(fault({{{0, 0}, {1, 0}, {0, 1}}}, Shape::triangle(2)), "");
}

TEST(Trim, IsRefusedNamingTheField) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(fault({kOuter, {{0, 0}, {1, 1}}}), "trim[1]: has 2 vertices, and needs 3");
  EXPECT_EQ(fault({{{0, 0}, {1, 0}, {0, std::nextafter(1, 2)}}}),
            "trim[0][2]: (0, 1.0000000000000002) lies outside the domain of a tensor");
  EXPECT_EQ(fault({{{0, 0}, {1, kTiny}, {0, 1}}}, Shape::triangle(1)),
            "trim[0][1]: (1, 5e-324) lies outside the domain of a triangle");
  EXPECT_EQ(fault({{{0, 0}, {1, 0}, {-kTiny, 1}}}),
            "trim[0][2]: (-5e-324, 1) lies outside the domain of a tensor");
  EXPECT_EQ(fault({{{0, 0}, {nan, 0}, {0, 1}}}), "trim[0][1]: (nan, 0) is not finite");
  EXPECT_EQ(fault({{{0, 0}, {0.5, 0.5}, {1, 1}}}), "trim[0]: has no area");
  EXPECT_EQ(fault({{{0, 0}, {1, 1}, {1, 0}, {0, 1}}}),
            "trim[0]: crosses or touches itself at the edges from vertices 0 and 2");
  EXPECT_EQ(fault({{{0, 0}, {1, 0}, {0.5, 0}, {0, 1}}}),
            "trim[0]: crosses or touches itself at the edges from vertices 0 and 1")
      << "a spike";
  EXPECT_EQ(fault({{{0, 0}, {1, 0}, {0, 1}, {0, 0}}}),
            "trim[0]: crosses or touches itself at the edges from vertices 0 and 2")
      << "closed twice";
  EXPECT_EQ(fault({kHole, {{0, 0.5}, {1, 0.5}, {1, 0.6}}}), "trim[1]: crosses loop 0");
  EXPECT_EQ(fault({kHole, {{0.5, 0.5}, {0.25, 0.25}, {0, 0.1}, {0.25, 0.75}}}),
            "trim[1]: crosses loop 0")
      << "through vertices";
  EXPECT_EQ(fault({kOuter}, Shape::curve(2)),
            "trim: only a triangle or a tensor is trimmed, not a curve");
  EXPECT_EQ(fault({std::vector<Uv<double>>(513)}), "trim: has 513 vertices, and may have 512");
}

TEST(Trim, OfAsManyVerticesAsMayBeTakesLittleTime) {
  // A path to and fro, whose edges' boxes all meet, with numbers of a thousand bits.
  std::vector<Uv<double>> loop = {{0, 0}};
  for (int i = 0; i < 255; ++i) {
    loop.push_back({0x1p-1000 * i, 0x1p-900});
    loop.push_back({1, 1 - 0x1p-20 * i});
    if (i % 2 == 1) std::swap(loop[loop.size() - 2], loop.back());
  }
  loop.push_back({1, 0});
  const auto start = std::chrono::steady_clock::now();
  EXPECT_EQ(fault({loop}), "");
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
  EXPECT_LT(took.count(), 10);
}

TrimRegion domain_of(const Trim& trim, const Shape& shape = Shape::tensor(1, 1)) {
  TrimRegion domain;
  MovingPatch<double> patch{shape, {}, {}};
  patch.trim = trim;
  domain.assign(patch);
  return domain;
}

TEST(TrimRegion, ItsBoundaryBelongsToIt) {
  const TrimRegion domain = domain_of({kOuter, kHole});
  const double inside = std::nextafter(0.25, 0), beyond = std::nextafter(0.25, 1);
  EXPECT_TRUE(domain.contains({0, 0}));
  EXPECT_TRUE(domain.contains({0.25, 0.5}));
  EXPECT_TRUE(domain.contains({0.25, 0.25}));
  EXPECT_TRUE(domain.contains({inside, 0.5}));
  EXPECT_FALSE(domain.contains({beyond, 0.5}));
  EXPECT_FALSE(domain.contains({0.5, 0.5}));
  EXPECT_TRUE(domain_of({}).contains({0.5, 0.5}));
}

TEST(TrimRegion, ParityCountsEachLoop) {
  const Trim rings = {kOuter, kHole, {{0.4, 0.4}, {0.6, 0.4}, {0.5, 0.6}}};
  EXPECT_TRUE(domain_of(rings).contains({0.5, 0.5})) << "on the island";
  EXPECT_FALSE(domain_of(rings).contains({0.3, 0.3})) << "in the hole";
  // The direction of a loop is nothing.
  Trim turned = rings;
  std::reverse(turned[1].begin(), turned[1].end());
  EXPECT_TRUE(domain_of(turned).contains({0.5, 0.5}));
  EXPECT_FALSE(domain_of(turned).contains({0.3, 0.3}));
}

TEST(TrimRegion, ACellIsOutsideOnlyIfItsClosureMissesTheRegion) {
  using Cover = TrimRegion::Cover;
  const Shape shape = Shape::tensor(1, 1);
  const Cell corner{0, 0, 1, false};  // [0, 1/2]²
  const auto cover = [&](const Uv<double>& a) {
    return domain_of({{a, {1, a[1]}, {1, 1}, {a[0], 1}}}).cover(corner);
  };
  EXPECT_EQ(cover({0.5, 0.5}), Cover::kCrossed) << "they share a corner";
  EXPECT_EQ(cover({std::nextafter(0.5, 1), 0.5}), Cover::kOutside);
  EXPECT_EQ(cover({0, 0}), Cover::kCrossed);
  EXPECT_EQ(domain_of({kOuter}).cover(Cell{}.child(shape, 0).child(shape, 3)), Cover::kInside);
  EXPECT_EQ(domain_of({kOuter, kHole}).cover({2, 2, 2, false}), Cover::kCrossed);
  EXPECT_EQ(domain_of({kOuter, kHole}).cover({3, 3, 3, false}), Cover::kOutside) << "in the hole";
  EXPECT_EQ(domain_of({kOuter, kHole}).cover(Cell{}), Cover::kCrossed) << "no vertex in the hole";
  // A loop within a cell, of which all vertices are outside.
  EXPECT_EQ(domain_of({{{0.3, 0.3}, {0.4, 0.3}, {0.3, 0.4}}}).cover(corner), Cover::kCrossed);
  const Trim beside = {{{0.25, 0.25}, {0.5, 0.25}, {0.25, 0.5}}};
  EXPECT_EQ(domain_of(beside, Shape::triangle(1)).cover({0, 0, 2, true}), Cover::kCrossed)
      << "they share a corner";
  EXPECT_EQ(domain_of({{{0.25, 0.25}, {0.5, 0}, {0.5, 0.25}}}, Shape::triangle(1))
                .cover({0, 0, 1, false}),
            Cover::kCrossed)
      << "along the diagonal";
  const double more = std::nextafter(0.5, 1);
  EXPECT_EQ(domain_of({{{0.25, 0.25 + 0x1p-54}, {more, 0}, {more, 0.25}}}, Shape::triangle(1))
                .cover({0, 0, 1, false}),
            Cover::kOutside);
}

TEST(TrimRegion, ChildrenOfACrossedCellAreTold) {
  const TrimRegion domain = domain_of({{{0, 0}, {0.25, 0}, {0, 0.25}}});
  const TrimRegion::Children children = domain.children(Cell{});
  EXPECT_EQ(children.outside, 0b1110U);
  EXPECT_EQ(children.crossed, 0b0001U);
}

}  // namespace
}  // namespace ccdfuzz
