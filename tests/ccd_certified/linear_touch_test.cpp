#include "ccd/certified/linear_touch.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "case/case_json.hpp"
#include "certify/linear/first_contact.hpp"
#include "generators/random.hpp"
#include "share.hpp"

namespace ccdfuzz::certified {
namespace {

/// Two edges, or a point and a face, that touch about t = ½, at weights of full doubles, at times a
/// corner or a point of an edge.
Query about_touching(Random& random) {
  const auto number = [&] {
    return std::ldexp(static_cast<double>(random.between(-(1LL << 53), 1LL << 53)), -53);
  };
  const bool edges = random.coin();
  Query query;
  std::array<Vec3<double>, 2> at;
  for (std::size_t s = 0; s < 2; ++s) {
    MovingPatch<double>& patch = query.patches[s];
    patch.shape = edges ? Shape::curve(1) : s == 0 ? Shape::point() : Shape::triangle(1);
    at[s] = {0, 0, 0};
    double left = 1;
    for (int i = patch.shape.control_count() - 1; i >= 0; --i) {
      const Vec3<double> p{number(), number(), number()}, v{number(), number(), number()};
      const double share = i == 0 ? left : random.pick(std::array{0.0, 1.0, 0.5, 0.25}) * left;
      left -= share;
      at[s] += share * (p + 0.5 * v);
      patch.positions.insert(patch.positions.begin(), p);
      patch.velocities.insert(patch.velocities.begin(), v);
    }
  }
  for (Vec3<double>& p : query.patches[0].positions) p += at[1] - at[0];
  return query;
}

// Also where the window ends or begins at the contact, as near as doubles are, and where corners
// pass each other, which are as often inside as outside.
TEST(LinearTouch, IsACertainContact) {
  Random random = Random::keyed({37});
  NormalisedQuery normalised;
  int certain = 0, total = 0;
  for (std::size_t i = 0; i < 6000 / kOneIn; ++i, ++total) {
    Query query = about_touching(random);
    const double width = random.pick(std::array{0x1p-50, 0x1p-40, 0x1p-13, 0x1p-13, 0x1p-13});
    const double from = random.pick(std::array{0.5 - width, 0.5 - width, 0.5});
    query.t_max = from + width * random.pick(std::array{1.0, 2.0});
    normalise(query, normalised);
    const double start = std::ldexp(from, -normalised.time);
    if (!certainly_touch(normalised, start, normalised.t_max)) continue;
    ++certain;
    // What begins at `from`, exactly.
    auto patches = linear::exact_patches(query);
    for (MovingPatch<Rational>& patch : patches) patch.positions = patch.at(exact(from));
    EXPECT_TRUE(linear::first_contact(patches, exact(query.t_max) - exact(from)))
        << to_hex(from) << "\n"
        << to_json({query, {}, {}, {}});
  }
  EXPECT_GT(certain, total / 25);
}

}  // namespace
}  // namespace ccdfuzz::certified
