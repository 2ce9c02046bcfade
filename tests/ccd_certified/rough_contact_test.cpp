#include "ccd/certified/rough_contact.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>

#include "case/case_json.hpp"
#include "certify/linear/first_contact.hpp"
#include "generators/random.hpp"
#include "share.hpp"

namespace ccdfuzz::certified {
namespace {

/// All bits in use.
double full_bits(Random& random) {
  return std::ldexp(static_cast<double>(random.between(-(1LL << 53), 1LL << 53)), -53);
}

/// Two edges, or a point and a face, that touch about t = ½ or nearly do, often with a corner or a
/// point of an edge.
Query about_touching(Random& random) {
  const auto number = [&] { return full_bits(random); };
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
      const double share =
          i == 0 ? left : random.pick(std::array{0.0, 1.0, 0.5, 0.25, 0.375, 0.6875}) * left;
      left -= share;
      at[s] += share * (p + 0.5 * v);
      patch.positions.insert(patch.positions.begin(), p);
      patch.velocities.insert(patch.velocities.begin(), v);
    }
  }
  const double apart = random.pick(std::array{0.0, 0.0, 0x1p-40, 0x1p-10});
  const Vec3<double> gap = apart * Vec3<double>{number(), number(), number()};
  for (Vec3<double>& p : query.patches[0].positions) p += at[1] - at[0] + gap;
  return query;
}

// Also where the window ends or begins at the contact, as near as doubles are, and where corners
// pass each other, which are as often inside as outside.
TEST(RoughContact, SaysWhatExactArithmeticFinds) {
  Random random = Random::keyed({37});
  NormalisedQuery normalised;
  int none = 0, proven = 0, total = 0;
  for (std::size_t i = 0; i < 6000 / kOneIn; ++i, ++total) {
    Query query = about_touching(random);
    const double length = random.pick(std::array{0x1p-50, 0x1p-40, 0x1p-13, 0.25, 0.5});
    const double from = random.pick(std::array{0.5 - length, 0.5 - 0.5 * length, 0.5});
    query.t_max = from + length * random.pick(std::array{1.0, 2.0});
    normalise(query, normalised);
    const int time = normalised.time;
    const double width = random.pick(std::array{0x1p-44, 0x1p-40, 0x1p-20, 1.0});
    const double first = random.pick(std::array{0.0, from + width});
    const auto normal = [&](double t) { return std::ldexp(t, -time); };
    const RoughContact rough =
        rough_contact(normalised, normal(from), normal(first), normal(width));
    if (rough.kind == RoughContact::Kind::kOpen) continue;
    // What begins at `from`, exactly.
    auto patches = linear::exact_patches(query);
    for (MovingPatch<Rational>& patch : patches) patch.positions = patch.at(exact(from));
    auto contact = linear::first_contact(patches, exact(query.t_max) - exact(from));
    const auto is_at_least = [&](const Rational& t) {
      return contact->time.sign_of(linear::Polynomial({-t.get_num(), t.get_den()})) >= 0;
    };
    const std::string shown = to_hex(from) + " " + to_hex(width) + " " + to_hex(rough.time) + "\n" +
                              to_json({query, {}, {}, {}});
    ASSERT_EQ(contact.has_value(), rough.kind == RoughContact::Kind::kProven) << shown;
    none += !contact;
    if (!contact) continue;
    ++proven;
    const Rational lo = exact(std::ldexp(rough.time, time)) - exact(from);
    EXPECT_TRUE(is_at_least(lo)) << shown;
    EXPECT_FALSE(is_at_least(lo + exact(width) * (1 + power_of_two(-50)))) << shown;
  }
  EXPECT_GT(proven, total / 10);
  EXPECT_GT(none, total / 10);
}

// Integers are slow: random queries are not to need them.
TEST(RoughContact, LeavesNoneInAThousandRandomQueriesOpen) {
  Random random = Random::keyed({38});
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
