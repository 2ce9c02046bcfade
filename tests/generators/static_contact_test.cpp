#include "generators/static_contact.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "bezier/blossom.hpp"
#include "generators/differential.hpp"
#include "generators/tangent_cone.hpp"
#include "numeric/products.hpp"

namespace ccdfuzz {
namespace {

template <class Check>
void for_each_contact(const Check& check) {
  for (const ContactClass contact : kContactClasses) {
    for (std::uint64_t key = 0; key < 50; ++key) {
      SCOPED_TRACE(fmt::format("{} key {}", name_of(contact), key));
      Draw random{Random(key)};
      std::array<Barycentric, 2> x;
      for (size_t s = 0; s < 2; ++s) x[s] = prescribe_in_parent(features_of(contact)[s], random);
      check(contact, x, static_contact(x, random));
    }
  }
}

TEST(StaticContact, ThePatchesCoincideExactlyAtTheContact) {
  for_each_contact([](ContactClass, const std::array<Barycentric, 2>& x,
                      const std::array<Points<Dyadic>, 2>& points) {
    const Uv<Dyadic> uv_1 = {x[0][0], x[0][1]}, uv_2 = {x[1][0], x[1][1]};
    EXPECT_EQ(evaluate<Dyadic>(kQuadratic, points[0], uv_1),
              evaluate<Dyadic>(kQuadratic, points[1], uv_2));
  });
}

// Eq. 19, on both faces of FF, on the face of EF and along its edge.
TEST(StaticContact, FacesAndEdgesOnFacesAreTangentExactly) {
  for_each_contact([](ContactClass contact, const std::array<Barycentric, 2>& x,
                      const std::array<Points<Dyadic>, 2>& points) {
    if (contact != ContactClass::kFF && contact != ContactClass::kEF) return;
    const TangentCone one = tangent_cone(points[0], x[0]), two = tangent_cone(points[1], x[1]);
    const Vec3<Dyadic> normal = cross(two.lines[0], two.lines[1]);
    for (const Vec3<Dyadic>& tangent : one.lines) EXPECT_EQ(dot(normal, tangent), Dyadic());
  });
}

// What extraction and the double's 53 bits count on.
TEST(StaticContact, NumbersStayOnTheGridAndInTheRange) {
  for_each_contact([](ContactClass, const std::array<Barycentric, 2>&,
                      const std::array<Points<Dyadic>, 2>& points) {
    for (const Points<Dyadic>& patch : points) {
      for (const Vec3<Dyadic>& p : patch) {
        for (int k = 0; k < 3; ++k) {
          EXPECT_GE(p[k].exponent(), p[k].sign() == 0 ? 0 : -15) << p[k];
          EXPECT_LT(abs(p[k]), Dyadic(1024)) << p[k];
        }
      }
    }
  });
}

}  // namespace
}  // namespace ccdfuzz
