#include "generators/paper.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace ccdfuzz {
namespace {

// What extraction and the double's 53 bits count on.
TEST(StaticContact, NumbersStayOnTheGridAndInTheRange) {
  for (const ContactClass contact : kContactClasses) {
    for (std::uint64_t key = 0; key < 50; ++key) {
      SCOPED_TRACE(fmt::format("{} key {}", name_of(contact), key));
      Draw random{Random(key)};
      std::array<Barycentric, 2> x;
      for (size_t s = 0; s < 2; ++s) x[s] = prescribe_in_parent(features_of(contact)[s], random);
      for (const Points<Dyadic>& patch : static_contact(x, random)) {
        for (const Vec3<Dyadic>& p : patch) {
          for (int k = 0; k < 3; ++k) {
            EXPECT_GE(p[k].exponent(), p[k].sign() == 0 ? 0 : -15) << p[k];
            EXPECT_LT(abs(p[k]), Dyadic(1024)) << p[k];
          }
        }
      }
    }
  }
}

}  // namespace
}  // namespace ccdfuzz
