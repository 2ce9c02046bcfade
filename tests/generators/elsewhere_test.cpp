#include "generators/elsewhere.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "generators/generate.hpp"
#include "generators/planted.hpp"

namespace ccdfuzz {
namespace {

double largest(const Query& query, const Points<double> MovingPatch<double>::*points) {
  double most = 0;
  for (const MovingPatch<double>& patch : query.patches) {
    for (const Vec3<double>& p : patch.*points) {
      for (int k = 0; k < 3; ++k) most = std::max(most, std::abs(p[k]));
    }
  }
  return most;
}

/// The case that elsewhere() makes of the highest numbers, or of the lowest ones where they have a
/// sign. (Choices go to and fro about 0.)
Case moved_as_far_as_it_goes(const Case& base, bool up) {
  const std::uint64_t vector = up ? 29 : 30, space = up ? 1799 : 1900, time = up ? 199 : 200;
  Draw draw = Draw::from_numbers(
      {1, 40, vector, vector, vector, 1, 40, vector, vector, vector, 3, space, 3, time});
  return elsewhere(base, draw);
}

TEST(Elsewhere, NothingChangesWhereEveryChoiceIs0) {
  Draw random{Random(1)};
  const Case base = planted_case(ContactClass::kEF, random);
  Draw zeros = Draw::from_numbers({});
  EXPECT_EQ(elsewhere(base, zeros), base);
}

TEST(Elsewhere, IsAsFarAndAsFastAsTheBitsAllow) {
  for (const ContactClass contact : kContactClasses) {
    Draw random{Random(2)};
    const Case base = planted_case(contact, random);
    for (const bool up : {false, true}) {
      const Case far = moved_as_far_as_it_goes(base, up);
      const double scale = up ? 0x1p900 : 0x1p-1000, unit = up ? 0x1p100 : 0x1p-100;
      EXPECT_EQ(far.query.t_max, base.query.t_max * unit);
      EXPECT_GT(largest(far.query, &MovingPatch<double>::positions), scale * 0x1p20);
      EXPECT_GT(largest(far.query, &MovingPatch<double>::velocities), scale / unit * 0x1p20);
    }
  }
}

TEST(Anywhere, ContactsComeInAllScalesAndPlaces) {
  constexpr std::uint64_t kCases = 60;
  int tiny = 0, huge = 0, fast = 0, proven = 0, early = 0;
  for (const ContactClass contact : kContactClasses) {
    for (std::uint64_t index = 0; index < kCases; ++index) {
      GeneratorOptions options{.contact = contact, .family = Family::kAnywhere};
      const Case made = generate(options, index).value;
      ASSERT_TRUE(made.truth.witness);
      EXPECT_EQ(made.origin.generator, "anywhere");
      const double size = largest(made.query, &MovingPatch<double>::positions);
      const double way = largest(made.query, &MovingPatch<double>::velocities) * made.query.t_max;
      tiny += size < 0x1p-700;
      huge += size > 0x1p700;
      fast += way > size * 0x1p25;
      proven += made.truth.clear_until.has_value();
      early += made.truth.witness->t < exact(made.query.t_max);
    }
  }
  for (const int kind : {tiny, huge, fast, proven, early}) EXPECT_GT(kind, 3);
}

}  // namespace
}  // namespace ccdfuzz
