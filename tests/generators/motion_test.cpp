#include "generators/motion.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "generators/extract.hpp"
#include "generators/prescribe.hpp"
#include "numeric/products.hpp"

namespace ccdfuzz {
namespace {

struct Moving {
  ContactClass contact;
  PrescribedContact prescribed;
  std::array<Points<Dyadic>, 2> points;
  Vec3<Dyadic> normal;
  std::array<MovingPatch<Dyadic>, 2> patches;
};

template <class Check>
void for_each_motion(const Check& check) {
  for (const ContactClass contact : kContactClasses) {
    for (std::uint64_t key = 0; key < 50; ++key) {
      SCOPED_TRACE(fmt::format("{} key {}", name_of(contact), key));
      Draw random{Random(key)};
      Moving m{contact, {Dyadic(1), {}}, {}, random.vector(4, 0), {}};
      for (size_t s = 0; s < 2; ++s) {
        const Barycentric x = prescribe_in_parent(features_of(contact)[s], random);
        m.prescribed.x[s] = choose_local_patch(x, random).x;
        for (size_t i = 0; i < 6; ++i) m.points[s].push_back(random.vector(46, -41));
      }
      m.patches = set_in_motion(m.points, m.prescribed, m.normal, contact, random);
      check(m);
    }
  }
}

TEST(Motion, ContactPointsOfVertexVertexMoveAnyWay) {
  int approaching = 0, all = 0;
  for_each_motion([&](const Moving& m) {
    if (m.contact != ContactClass::kVV) return;
    const auto weights = bernstein_weights(m.prescribed.x[0]);
    ++all;
    approaching += dot(m.normal, weighted_sum(weights, m.patches[0].velocities)).sign() < 0;
  });
  EXPECT_GT(approaching, all / 5);
  EXPECT_LT(approaching, 4 * all / 5);
}

TEST(Motion, AllNumbersAreDoubles) {
  for_each_motion([](const Moving& m) {
    for (const MovingPatch<Dyadic>& patch : m.patches) {
      for (size_t i = 0; i < 6; ++i) {
        for (int k = 0; k < 3; ++k) {
          EXPECT_TRUE(patch.positions[i][k].to_double_exactly()) << patch.positions[i][k];
          EXPECT_TRUE(patch.velocities[i][k].to_double_exactly()) << patch.velocities[i][k];
        }
      }
    }
  });
}

}  // namespace
}  // namespace ccdfuzz
