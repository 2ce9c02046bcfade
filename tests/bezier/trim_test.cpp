// Loops that a patch may have. trims.cells states which region they bound.
#include "bezier/trim.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

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

TEST(Trim, IsRefusedNamingTheField) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(fault({kOuter, {{0, 0}, {1, 1}}}), "trim[1]: has 2 vertices, and needs 3");
  EXPECT_EQ(
      fault({{{0, 0}, {1, 0}, {0, std::nextafter(1, 2)}}}),
      "trim[0][2]: (0, 1.0000000000000002) lies outside the domain of a tensor, u and v in [0, 1]");
  EXPECT_EQ(
      fault({{{0, 0}, {1, kTiny}, {0, 1}}}, Shape::triangle(1)),
      "trim[0][1]: (1, 5e-324) lies outside the domain of a triangle, u ≥ 0, v ≥ 0 and u + v ≤ 1");
  EXPECT_EQ(fault({{{0, 0}, {1, 0}, {-kTiny, 1}}}),
            "trim[0][2]: (-5e-324, 1) lies outside the domain of a tensor, u and v in [0, 1]");
  EXPECT_EQ(fault({{{0, 0}, {nan, 0}, {0, 1}}}), "trim[0][1]: (nan, 0) is not finite");
  EXPECT_EQ(fault({{{0, 0}, {0.5, 0.5}, {1, 1}}}), "trim[0]: has no area");
  EXPECT_EQ(fault({{{0, 0}, {1, 1}, {1, 0}, {0, 1}}}),
            "trim[0]: crosses or touches itself at the edges from vertices 0 and 2");
  EXPECT_EQ(fault({{{0, 0}, {1, 0}, {0.5, 0}, {0, 1}}}),
            "trim[0]: crosses or touches itself at the edges from vertices 0 and 1")
      << "a spike";
  EXPECT_EQ(fault({{{0, 0}, {1, 0}, {0, 1}, {0, 0}}}),
            "trim[0]: vertex 3 repeats vertex 0: the last vertex is joined to the first anyway");
  EXPECT_EQ(fault({{{0, 0}, {0, 0}, {1, 0}, {0, 1}}}), "trim[0]: vertex 1 repeats vertex 0");
  EXPECT_EQ(fault({kHole, {{0, 0.5}, {1, 0.5}, {1, 0.6}}}), "trim[1]: crosses loop 0");
  EXPECT_EQ(fault({kHole, {{0.5, 0.5}, {0.25, 0.25}, {0, 0.1}, {0.25, 0.75}}}),
            "trim[1]: crosses loop 0")
      << "through vertices";
  EXPECT_EQ(fault({kOuter}, Shape::curve(2)),
            "trim: only a triangle or a tensor is trimmed, not a curve");
  EXPECT_EQ(fault({std::vector<Uv<double>>(513)}), "trim: has 513 vertices, and may have 512");
}

TEST(Trim, OfAsManyVerticesAsMayBeIsNoHang) {
  // A path to and fro, whose edges' boxes all meet, with numbers of a thousand bits. What takes
  // minutes is ended as a hang.
  std::vector<Uv<double>> loop = {{0, 0}};
  for (int i = 0; i < 255; ++i) {
    loop.push_back({0x1p-1000 * i, 0x1p-900});
    loop.push_back({1, 1 - 0x1p-20 * i});
    if (i % 2 == 1) std::swap(loop[loop.size() - 2], loop.back());
  }
  loop.push_back({1, 0});
  EXPECT_EQ(fault({loop}), "");
}

TEST(TrimRegion, ChildrenOfACrossedCellAreTold) {
  MovingPatch<double> patch{Shape::tensor(1, 1), {}, {}};
  patch.trim = {{{0, 0}, {0.25, 0}, {0, 0.25}}};
  TrimRegion domain;
  domain.assign(patch);
  const TrimRegion::Children children = domain.children(Cell{});
  EXPECT_EQ(children.outside, 0b1110U);
  EXPECT_EQ(children.crossed, 0b0001U);
}

}  // namespace
}  // namespace ccdfuzz
