#include "generators/one_sided.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "bezier/blossom.hpp"
#include "features.hpp"
#include "generators/moving_plane.hpp"
#include "generators/prescribe.hpp"
#include "numeric/products.hpp"

namespace ccdfuzz {
namespace {

template <class Check>
void for_each_one_sided_scene(const OneSidedStyle& style, const Check& check) {
  for (const ContactClass contact : kContactClasses) {
    for (std::uint64_t key = 0; key < 40; ++key) {
      SCOPED_TRACE(fmt::format("{} key {}", name_of(contact), key));
      Draw random{Random(key)};
      check(contact, one_sided_scene(contact, style, random), random);
    }
  }
}

Vec3<Dyadic> contact_of(const Scene& scene, size_t s) {
  return evaluate(scene.patches[s], dyadic_uv(scene.contact.x[s]), scene.contact.t);
}

TEST(OneSided, ThePatchesCoincideExactlyAtTheContact) {
  for_each_one_sided_scene({}, [](ContactClass, const Scene& scene, Draw&) {
    EXPECT_EQ(contact_of(scene, 0), contact_of(scene, 1));
  });
}

TEST(OneSided, TheMovingPlaneAlwaysProvesIt) {
  OneSidedStyle earlier;
  earlier.t = Dyadic(3, -2);
  for (const OneSidedStyle& style : {OneSidedStyle{}, earlier}) {
    for_each_one_sided_scene(style, [](ContactClass, const Scene& scene, Draw&) {
      EXPECT_TRUE(moving_plane_separates(scene, scene.normal));
    });
  }
}

// The claim behind the proof, on the surfaces themselves rather than on their control points.
TEST(OneSided, RandomPointsAreOnTheirOwnSidesOfThePlaneBeforeTheContact) {
  for_each_one_sided_scene({}, [](ContactClass, const Scene& scene, Draw& random) {
    for (int i = 0; i < 10; ++i) {
      std::array<Uv<Dyadic>, 2> at;
      for (Uv<Dyadic>& p : at) p = dyadic_uv(prescribe_anywhere(Feature::kFace, 10, random));
      const Dyadic before(static_cast<int>(random.integer(0, 1023)), -10);
      const Vec3<Dyadic> offset =
          evaluate(scene.patches[0], at[0], before) - evaluate(scene.patches[1], at[1], before);
      EXPECT_GT(dot(scene.normal, offset).sign(), 0) << "t = " << before;
      const Vec3<Dyadic> at_contact = evaluate(scene.patches[0], at[0], scene.contact.t) -
                                      evaluate(scene.patches[1], at[1], scene.contact.t);
      EXPECT_GT(dot(scene.normal, at_contact).sign(), 0) << "apart from the contact";
    }
  });
}

// A contact at the origin hides false negatives, for there rounding errors cancel.
TEST(OneSided, TheContactPointIsFarFromTheOriginAndUsesManyBits) {
  int far = 0, long_numbers = 0, all = 0;
  for_each_one_sided_scene({}, [&](ContactClass, const Scene& scene, Draw&) {
    const Vec3<Dyadic> c = contact_of(scene, 0);
    ++all;
    far += abs(c[0]) > Dyadic(1);
    long_numbers += mpz_sizeinbase(c[0].mantissa().get_mpz_t(), 2) >= 40;
  });
  EXPECT_GT(far, 9 * all / 10);
  EXPECT_GT(long_numbers, 9 * all / 10);
}

TEST(OneSided, GrazingPatchesKeepTheirHeightsAndNeverCross) {
  OneSidedStyle style;
  style.grazing = true;
  for_each_one_sided_scene(style, [](ContactClass, const Scene& scene, Draw&) {
    EXPECT_EQ(contact_of(scene, 0), contact_of(scene, 1));
    EXPECT_FALSE(moving_plane_separates(scene, scene.normal));
    for (const MovingPatch<Dyadic>& patch : scene.patches) {
      for (const Vec3<Dyadic>& v : patch.velocities) EXPECT_EQ(dot(scene.normal, v), Dyadic());
    }
  });
}

}  // namespace
}  // namespace ccdfuzz
