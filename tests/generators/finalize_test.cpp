#include "generators/finalize.hpp"

#include <gtest/gtest.h>

#include "generators/paper.hpp"

namespace ccdfuzz {
namespace {

Scene some_scene() {
  Draw random{Random(1)};
  return *random.until([&] { return paper_scene(ContactClass::kVE, false, random); },
                       [](const auto& scene) { return scene && to_query(scene->patches, 1); });
}

TEST(Finalize, ANumberThatNoDoubleHoldsIsRefused) {
  const Dyadic too_long = Dyadic(1) + Dyadic(1, -53);
  for (const Dyadic& bad : {too_long, Dyadic(1, -1075), Dyadic(1, 1024)}) {
    Scene scene = some_scene();
    scene.patches[1].positions[3][2] = bad;
    EXPECT_FALSE(to_query(scene.patches, 1)) << bad;
    scene = some_scene();
    scene.patches[0].velocities[5][0] = bad;
    EXPECT_FALSE(to_query(scene.patches, 1)) << bad;
    EXPECT_FALSE(to_query(some_scene().patches, bad)) << bad;
  }
}

// A construction that is wrong does not get out.
TEST(Finalize, AContactThatIsNoneIsABrokenInvariant) {
  Scene scene = some_scene();
  for (Vec3<Dyadic>& p : scene.patches[0].positions) p[0] += Dyadic(1, -40);
  Case value;
  value.query = to_query(scene.patches, 1).value();
  const auto& [t, x] = scene.contact;
  EXPECT_THROW(say_contact(value, {t.rational(), {uv_of(x[0]), uv_of(x[1])}}), InternalError);
}

}  // namespace
}  // namespace ccdfuzz
