#include "generators/twins.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace ccdfuzz {
namespace {

/// The exponent e with 2^(e-1) ≤ |x| < 2^e, x ≠ 0.
long magnitude(const Dyadic& x) {
  return x.exponent() + static_cast<long>(mpz_sizeinbase(x.mantissa().get_mpz_t(), 2));
}

/// True iff the velocities of two control points, and their positions if those count too, are
/// within 4 ulps of the largest number among them.
bool within_ulps(const MovingPatch<Dyadic>& patch, size_t i, size_t j, bool positions_too) {
  for (int k = 0; k < 3; ++k) {
    Dyadic largest;
    for (const size_t c : {i, j}) {
      largest = std::max({largest, abs(patch.velocities[c][k]), abs(patch.positions[c][k])});
    }
    if (largest.sign() == 0) continue;
    const Dyadic four_ulps(4, magnitude(largest) - 53);
    if (abs(patch.velocities[i][k] - patch.velocities[j][k]) > four_ulps) return false;
    if (positions_too && abs(patch.positions[i][k] - patch.positions[j][k]) > four_ulps) {
      return false;
    }
  }
  return true;
}

TEST(Twins, TwoMidControlsOfACornerAreAFewUlpsApartAndMostlyNotEqual) {
  int equal = 0, different = 0, coincident = 0;
  for (std::uint64_t key = 0; key < 25 * kContactClasses.size(); ++key) {
    const ContactClass contact = kContactClasses[key % kContactClasses.size()];
    SCOPED_TRACE(fmt::format("{} key {}", name_of(contact), key));
    Draw random{Random(key)};
    const Scene scene = twin_scene(contact, random);
    const MovingPatch<Dyadic>& patch = scene.patches[0];
    int pairs = 0;
    for (int corner = 0; corner < 3; ++corner) {
      const size_t i = control_of(corner, (corner + 1) % 3);
      const size_t j = control_of(corner, (corner + 2) % 3);
      if (!within_ulps(patch, i, j, false)) continue;
      ++pairs;
      ++(patch.velocities[i] == patch.velocities[j] ? equal : different);
      coincident += within_ulps(patch, i, j, true);
    }
    EXPECT_EQ(pairs, 1);
  }
  EXPECT_GT(different, equal);
  EXPECT_GT(coincident, (equal + different) / 4) << "twins in space too";
}

}  // namespace
}  // namespace ccdfuzz
