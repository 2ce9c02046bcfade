#include "ccd/certified/rough_contact.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "generators/draw/draw.hpp"
#include "share.hpp"

namespace ccdfuzz::certified {
namespace {

/// All bits in use.
double full_bits(Draw& random) {
  return std::ldexp(static_cast<double>(random.integer(-(1LL << 53), 1LL << 53)), -53);
}

// Integers are slow: random queries are not to need them.
TEST(RoughContact, LeavesNoneInAThousandRandomQueriesOpen) {
  Draw random{Random::keyed({38})};
  NormalisedQuery normalised;
  std::size_t open = 0;
  constexpr std::size_t kQueries = 20'000 / kOneIn;
  for (std::size_t i = 0; i < kQueries; ++i) {
    Query query;
    const bool edges = random.coin();
    for (std::size_t s = 0; s < 2; ++s) {
      MovingPatch<double>& patch = query.patches[s];
      patch.shape = edges ? Shape::curve(1) : s == 0 ? Shape::point() : Shape::triangle(1);
      for (int c = 0; c < patch.shape.control_count(); ++c) {
        Vec3<double> p, v;
        for (int k = 0; k < 3; ++k) p[k] = full_bits(random);
        for (int k = 0; k < 3; ++k) v[k] = full_bits(random);
        patch.positions.push_back(p);
        patch.velocities.push_back(v);
      }
    }
    normalise(query, normalised);
    open += rough_contact(normalised, 0, 0, 0x1p-14).kind == RoughContact::Kind::kOpen;
  }
  EXPECT_LT(1000 * open, kQueries);
}

}  // namespace
}  // namespace ccdfuzz::certified
