#include "generators/prescribe.hpp"

#include <gtest/gtest.h>

#include <set>

#include "generators/shaped/features.hpp"

namespace ccdfuzz {
namespace {

constexpr std::array kFeatures = {Feature::kFace, Feature::kEdge, Feature::kCorner};

TEST(Prescribe, NamesTheFeaturesInTheOrderOfTheClassName) {
  for (const ContactClass contact : kContactClasses) {
    const std::string_view name = name_of(contact);
    for (size_t s = 0; s < 2; ++s) {
      const Feature feature = features_of(contact)[s];
      const char letter = feature == Feature::kFace ? 'F' : feature == Feature::kEdge ? 'E' : 'V';
      EXPECT_EQ(letter, name[s]) << name;
    }
  }
}

TEST(Prescribe, ReachesEveryEdgeAndEveryCorner) {
  Draw random{Random(2)};
  for (const Feature feature : {Feature::kEdge, Feature::kCorner}) {
    std::set<int> zeros_in_parent, zeros_anywhere;
    const auto zeros = [](const Dyadic& u, const Dyadic& v) {
      return (u.sign() == 0 ? 1 : 0) + (v.sign() == 0 ? 2 : 0) + (u + v == Dyadic(1) ? 4 : 0);
    };
    for (int i = 0; i < 100; ++i) {
      const Barycentric x = prescribe_in_parent(feature, random);
      zeros_in_parent.insert(zeros(x[0], x[1]));
      const auto [u, v] = point_on(feature, kQuadratic, 6, random);
      zeros_anywhere.insert(zeros(u, v));
    }
    EXPECT_EQ(zeros_in_parent.size(), 3u);
    EXPECT_EQ(zeros_anywhere.size(), 3u);
  }
}

// Appendix E.2, and the minors of such parameters being powers of two, rest on these very values.
TEST(Prescribe, ParentParametersLieOnTheirFeatureAndArePowersOfTwo) {
  Draw random{Random(3)};
  for (const Feature feature : kFeatures) {
    for (int i = 0; i < 50; ++i) {
      const Barycentric x = prescribe_in_parent(feature, random);
      EXPECT_EQ(feature_at(x), feature);
      for (const Dyadic& c : x) {
        EXPECT_TRUE(c.sign() == 0 || c.mantissa() == 1) << c;
        EXPECT_GE(c.exponent(), -2) << c;
      }
    }
  }
}

TEST(Prescribe, AnywhereLiesOnItsFeatureAndHonoursItsBits) {
  Draw random{Random(4)};
  for (const Feature feature : kFeatures) {
    for (int bits = 2; bits <= 12; ++bits) {
      const Uv<Dyadic> uv = point_on(feature, kQuadratic, bits, random);
      EXPECT_EQ(feature_at(kQuadratic, uv), feature);
      for (const Dyadic& c : uv) EXPECT_GE(c.exponent(), -bits) << c;
    }
  }
}

}  // namespace
}  // namespace ccdfuzz
