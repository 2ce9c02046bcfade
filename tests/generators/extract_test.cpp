#include "generators/paper.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <set>

#include "bezier/restrict.hpp"
#include "generators/prescribe.hpp"

namespace ccdfuzz {
namespace {

template <class Check>
void for_each_part(const Check& check) {
  for (const Feature feature : {Feature::kFace, Feature::kEdge, Feature::kCorner}) {
    for (std::uint64_t key = 0; key < 100; ++key) {
      SCOPED_TRACE(fmt::format("feature {} key {}", static_cast<int>(feature), key));
      Draw random{Random(key)};
      const Barycentric x = prescribe_in_parent(feature, random);
      check(feature, x, choose_local_patch(x, random), random);
    }
  }
}

TEST(Extract, CornersAreOnTheGridAndInTheParent) {
  for_each_part([](Feature, const Barycentric&, const LocalPatch& part, Draw&) {
    for (const Barycentric& corner : part.corners) {
      EXPECT_EQ(corner[0] + corner[1] + corner[2], Dyadic(1));
      for (const Dyadic& c : corner) {
        EXPECT_GE(c.sign(), 0) << c;
        EXPECT_GE(c.exponent(), c.sign() == 0 ? 0 : -kGridBits) << c;
      }
    }
  });
}

TEST(Extract, ControlPointsAreTheBlossomAtTheCorners) {
  for_each_part([](Feature, const Barycentric&, const LocalPatch& part, Draw& random) {
    Points<Dyadic> parent;
    for (size_t i = 0; i < 6; ++i) parent.push_back(random.vector(12, -8));
    // restrict_to takes the corners in the order w, u, v.
    std::array<Uv<Dyadic>, 3> corners;
    for (size_t k = 0; k < 3; ++k) {
      const Barycentric& corner = part.corners[(k + 2) % 3];
      corners[k] = {corner[0], corner[1]};
    }
    Points<Dyadic> expected(6);
    restrict_to<Dyadic>(kQuadratic, parent, corners, expected);
    EXPECT_EQ(extract(parent, part), expected);
  });
}

TEST(Extract, ReachesEveryEdgeAndCornerOfThePart) {
  std::array<std::set<int>, 3> zeros;
  for_each_part([&](Feature feature, const Barycentric&, const LocalPatch& part, Draw&) {
    int mask = 0;
    for (int a = 0; a < 3; ++a) mask |= part.x[a].sign() == 0 ? 1 << a : 0;
    zeros[static_cast<size_t>(feature)].insert(mask);
  });
  EXPECT_EQ(zeros[static_cast<size_t>(Feature::kEdge)].size(), 3u);
  EXPECT_EQ(zeros[static_cast<size_t>(Feature::kCorner)].size(), 3u);
}

TEST(Extract, PartsAreNotDegenerate) {
  for_each_part([](Feature, const Barycentric&, const LocalPatch& part, Draw&) {
    const auto& c = part.corners;
    const Dyadic area =
        (c[1][0] - c[0][0]) * (c[2][1] - c[0][1]) - (c[1][1] - c[0][1]) * (c[2][0] - c[0][0]);
    EXPECT_NE(area, Dyadic());
  });
}

}  // namespace
}  // namespace ccdfuzz
