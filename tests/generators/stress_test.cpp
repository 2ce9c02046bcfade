#include "generators/stress.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "certify/checker/check_witness.hpp"
#include "generators/prescribe.hpp"
#include "numeric/products.hpp"

namespace ccdfuzz {
namespace {

constexpr std::uint64_t kCases = 25;

template <class Check>
void for_each_scene(Family family, const Check& check) {
  for (const ContactClass contact : kContactClasses) {
    for (std::uint64_t key = 0; key < kCases; ++key) {
      SCOPED_TRACE(fmt::format("{} {} key {}", name_of(family), name_of(contact), key));
      Draw random{Random(key)};
      check(stress_scene(family, contact, random));
    }
  }
}

template <class Check>
void for_each_number(const Scene& scene, const Check& check) {
  for (const MovingPatch<Dyadic>& patch : scene.patches) {
    for (size_t i = 0; i < 6; ++i) {
      for (int k = 0; k < 3; ++k) check(patch.positions[i][k], patch.velocities[i][k]);
    }
  }
}

/// The exponent e with 2^(e-1) ≤ |x| < 2^e, x ≠ 0.
long magnitude(const Dyadic& x) {
  return x.exponent() + static_cast<long>(mpz_sizeinbase(x.mantissa().get_mpz_t(), 2));
}

TEST(Stress, EveryFamilyAndClassGivesPositivesThatTheCheckerAccepts) {
  for (const Family family : kQuadraticFamilies) {
    for (const ContactClass contact : kContactClasses) {
      for (std::uint64_t index = 0; index < kCases; ++index) {
        SCOPED_TRACE(fmt::format("{} {} index {}", name_of(family), name_of(contact), index));
        GeneratorOptions options;
        options.contact = contact;
        options.family = family;
        const Case c = generate(options, index).value;
        ASSERT_EQ(c.truth.collides, true);
        ASSERT_TRUE(c.truth.witness);
        const Result<void> checked = check_witness(c.query, *c.truth.witness);
        EXPECT_TRUE(checked) << checked.error().message();
        EXPECT_FALSE(c.truth.clear_until) << "nothing is proven of the time before";
        EXPECT_EQ(c.origin.generator, name_of(family));
        EXPECT_EQ(c.origin.kind, "RP");
      }
    }
  }
}

TEST(Stress, TheContactLiesOnTheFeaturesThatItsClassNames) {
  for (const Family family : kQuadraticFamilies) {
    for (const ContactClass contact : kContactClasses) {
      Draw random{Random(7)};
      const Scene scene = stress_scene(family, contact, random);
      for (size_t s = 0; s < 2; ++s) {
        EXPECT_EQ(feature_at(scene.contact.x[s]), features_of(contact)[s]) << name_of(family);
      }
    }
  }
}

// Heights above the contact plane do not change, are of one sign, and 0 at the contact.
TEST(Stress, FlatGrazingSlidesAlongAPlaneThroughTheOrigin) {
  for_each_scene(Family::kFlatGrazing, [](const Scene& scene) {
    for (size_t s = 0; s < 2; ++s) {
      for (size_t i = 0; i < 6; ++i) {
        EXPECT_EQ(dot(scene.normal, scene.patches[s].velocities[i]), Dyadic());
      }
      const Points<Dyadic> points = scene.patches[s].at(scene.contact.t);
      const Vec3<Dyadic> contact = weighted_sum(bernstein_weights(scene.contact.x[s]), points);
      EXPECT_EQ(dot(scene.normal, contact), Dyadic()) << "the plane passes through the origin";
    }
  });
}

TEST(Stress, CommonVelocityIsLargeAndTheSameForAll) {
  for_each_scene(Family::kCommonVelocity, [](const Scene& scene) {
    // What differs between control points is small, below 2^4 a coordinate; the mean is not.
    const Vec3<Dyadic> first = scene.patches[0].velocities[0];
    long largest = 0;
    for (int k = 0; k < 3; ++k) {
      if (first[k].sign() != 0) largest = std::max(largest, magnitude(first[k]));
    }
    for (const MovingPatch<Dyadic>& patch : scene.patches) {
      for (const Vec3<Dyadic>& v : patch.velocities) {
        for (int k = 0; k < 3; ++k) EXPECT_LE(abs(v[k] - first[k]), Dyadic(32)) << v[k];
      }
    }
    EXPECT_GE(largest, 4);
  });
}

TEST(Stress, ScalesReachWhereProductsUnderflowAndStayDoubles) {
  bool tiny = false, large = false;
  for_each_scene(Family::kScaled, [&](const Scene& scene) {
    EXPECT_EQ(scene.t_max, Dyadic(2));
    for_each_number(scene, [&](const Dyadic& p, const Dyadic& v) {
      EXPECT_TRUE(p.to_double_exactly()) << p;
      EXPECT_TRUE(v.to_double_exactly()) << v;
      if (p.sign() == 0) return;
      tiny |= magnitude(p) < -537;
      large |= magnitude(p) > 100;
    });
  });
  EXPECT_TRUE(tiny);
  EXPECT_TRUE(large);
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

TEST(Stress, TwoMidControlsOfACornerAreTwinsAndMostlyNotEqual) {
  int equal = 0, different = 0, coincident = 0;
  for_each_scene(Family::kTwins, [&](const Scene& scene) {
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
  });
  EXPECT_GT(different, equal);
  EXPECT_GT(coincident, (equal + different) / 4) << "twins in space too";
}

TEST(Stress, InteriorContactsComeBeforeTheEnd) {
  for_each_scene(Family::kInteriorTime, [](const Scene& scene) {
    EXPECT_GT(scene.contact.t, Dyadic());
    EXPECT_LT(scene.contact.t, scene.t_max);
  });
}

TEST(Stress, HasNoNegatives) {
  GeneratorOptions options;
  options.family = Family::kTwins;
  options.kind = CaseKind::kRN;
  const Result<void> refused = validate(options);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().message(), "--kind: RN is not generated in the family twins");
}

}  // namespace
}  // namespace ccdfuzz
