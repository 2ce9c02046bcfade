#include "ccd/certified/linear_contact.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "ccd/certified/normalise.hpp"
#include "ccd/certified/rough_contact.hpp"
#include "ccd/certified/tdibm_c.hpp"
#include "certify/linear/first_contact.hpp"
#include "files/case_json.hpp"
#include "generators/draw/draw.hpp"
#include "share.hpp"

namespace ccdfuzz::certified {
namespace {

using Kind = LinearContact::Kind;

constexpr double kPrecision = 1e-4;

MovingPatch<double> patch(const Shape& shape, Points<double> positions,
                          Points<double> velocities = {}) {
  if (velocities.empty()) velocities.assign(positions.size(), Vec3<double>::Zero());
  return {shape, std::move(positions), std::move(velocities)};
}

/// How tdibm-c differs from the exact decider; empty if it does not.
std::string difference(const Query& query) {
  TdibmC method;
  const Answer answer = method.answer(query, {.precision = kPrecision});
  const auto contact = linear::first_contact(query);
  const bool hit = answer.verdict == Verdict::kHit;
  std::string wrong;
  if (answer.verdict != (contact ? Verdict::kHit : Verdict::kMiss)) {
    wrong = contact ? "misses a contact" : "finds a contact where there is none";
  } else if (hit && exact(*answer.toi) > contact->hi()) {
    wrong = fmt::format("late at {}", to_hex(*answer.toi));
  } else if (hit &&
             contact->lo() - exact(*answer.toi) >
                 exact(kPrecision * query.t_max + std::numeric_limits<double>::denorm_min())) {
    wrong = fmt::format("early at {}", to_hex(*answer.toi));
  }
  return wrong.empty() ? "" : wrong + "\n" + to_json({query, {}, {}, {}});
}

Kind kind_of(const Query& query) {
  return first_linear_contact(query, 44).kind;
}

Query point_above_face(double height, double level, double scale) {
  Query query{{patch(Shape::point(), {{0.25, 0.25, level + height}}),
               patch(Shape::triangle(1), {{0, 0, level}, {0, 1, level}, {1, 0, level}})},
              1};
  for (MovingPatch<double>& p : query.patches) {
    for (Vec3<double>& x : p.positions) x *= scale;
  }
  return query;
}

TEST(LinearContact, TellsTheLeastGapFromATouch) {
  for (const double level : {0.0, 1.0, -3.0}) {
    for (const double scale : {1.0, 0x1p-900, 0x1p900}) {
      EXPECT_EQ(difference(point_above_face(0, level, scale)), "");
      for (int e = -1; e >= -120; --e) {
        for (const double gap : {std::ldexp(1, e), std::ldexp(-1.5, e)}) {
          EXPECT_EQ(difference(point_above_face(gap, level, scale)), "");
        }
      }
    }
  }
}

// Points in full doubles on, or next to, oblique planes: the distance is below any E.
TEST(LinearContact, DecidesAtObliquePlanes) {
  Draw random{Random::keyed({31})};
  const auto number = [&] {
    return std::ldexp(static_cast<double>(random.integer(-(1LL << 53), 1LL << 53)), -53);
  };
  int hits = 0, total = 0;
  for (size_t i = 0; i < 4000 / kOneIn; ++i, ++total) {
    Points<double> face;
    for (int c = 0; c < 3; ++c) face.push_back({number(), number(), number()});
    const double u = random.pick(std::array{0.25, 0.5, 0.125}),
                 v = random.pick(std::array{0.0, 0.25, 0.5});
    const Vec3<double> inside = face[0] + u * (face[2] - face[0]) + v * (face[1] - face[0]);
    const double speed = random.pick(std::array{0.0, 0x1p-60, 0x1p-40});
    const Query query{{patch(Shape::point(), {inside}, {{number() * speed, number() * speed, 0}}),
                       patch(Shape::triangle(1), face)},
                      random.pick(std::array{1.0, 0.7, 0x1p-30})};
    ASSERT_EQ(difference(query), "");
    hits += kind_of(query) == Kind::kProven;
  }
  EXPECT_GT(hits, total / 20);
  EXPECT_LT(hits, total - total / 20);
}

/// Two edges or a point and a face about the origin, at `bits` bits a number.
Query about_origin(Draw& random, int bits) {
  const bool edges = random.coin();
  Query query;
  for (std::size_t s = 0; s < 2; ++s) {
    query.patches[s].shape = edges ? Shape::curve(1) : s == 0 ? Shape::point() : Shape::triangle(1);
    for (int i = 0; i < query.patches[s].shape.control_count(); ++i) {
      for (Points<double>* points : {&query.patches[s].positions, &query.patches[s].velocities}) {
        Vec3<double> p;
        for (int k = 0; k < 3; ++k) {
          p[k] =
              std::ldexp(static_cast<double>(random.integer(-(1LL << bits), 1LL << bits)), -bits);
        }
        points->push_back(p);
      }
    }
  }
  query.t_max = random.pick(std::array{1.0, 0.7, 2.0});
  return query;
}

/// Whether integers decide as another code in GMP does.
void expect_decided(const Query& query) {
  ASSERT_EQ(kind_of(query), linear::first_contact(query) ? Kind::kProven : Kind::kNone)
      << to_json({query, {}, {}, {}});
}

/// Two patches about the origin with coordinates that are −1, 0 or 1, which rest or move likewise.
Query on_a_grid(Draw& random, bool is_flat, bool moves) {
  Query query = about_origin(random, 0);
  for (MovingPatch<double>& patch : query.patches) {
    for (Points<double>* points : {&patch.positions, &patch.velocities}) {
      for (Vec3<double>& p : *points) {
        if (is_flat) p[2] = 0;
        if (!moves && points == &patch.velocities) p.setZero();
      }
    }
  }
  return query;
}

// Many of these polygons have no area, and many have the origin on an edge or at a corner.
TEST(LawL1, SaysWhetherTheOriginIsInThePolygon) {
  Draw random{Random::keyed({42})};
  for (std::size_t i = 0; i < 4000 / kOneIn; ++i) {
    expect_decided(on_a_grid(random, random.coin(), false));
  }
}

// In a plane the determinant is 0 at all times.
TEST(LawL2, FindsTheFirstContactInAPlane) {
  Draw random{Random::keyed({43})};
  for (std::size_t i = 0; i < 4000 / kOneIn; ++i) expect_decided(on_a_grid(random, true, true));
}

// Of small integers the determinant has irrational roots, at which other polynomials are 0, too.
TEST(LawL5, FindsSignsAtIrrationalTimes) {
  Draw random{Random::keyed({44})};
  for (std::size_t i = 0; i < 2000 / kOneIn; ++i) {
    expect_decided(about_origin(random, random.pick(std::array{1, 2, 3})));
  }
}

// Coordinates of the most binary places that are promised: a size beyond L6 would throw.
TEST(LawL6, TheLongestNumbersFit) {
  Draw random{Random::keyed({45})};
  for (std::size_t i = 0; i < 400 / kOneIn; ++i) {
    Query query = on_a_grid(random, false, true);
    query.t_max = 1;
    for (MovingPatch<double>& patch : query.patches) {
      for_each_coordinate(patch, [&](double& x) {
        x *= random.pick(std::array{1.0, 2 - 0x1p-52, 0x1p-253, 3 * 0x1p-253});
      });
    }
    const Kind kind = kind_of(query);
    ASSERT_NE(kind, Kind::kTooWide);
    ASSERT_NE(kind, Kind::kOpen);
    ASSERT_EQ(kind == Kind::kProven, linear::first_contact(query).has_value());
  }
}

TEST(LawL6, AProductTakesTheLimbsOfBothFactors) {
  // det is about 2^770·(t − 1/8)²·(t − 15/16), of numbers with 255 binary places.
  constexpr double kMost = (0x1p49 - 1) * 0x1p196, kA = kMost / 8, kC = kMost / 16 * 15;
  Query query{{patch(Shape::triangle(1), {{-kA, -0.125, kC}, {kA, -kA, -0.9375}, {-0.125, kA, -kC}},
                     {{kMost, 1, -kMost}, {-kMost, kMost, 1}, {1, -kMost, kMost}}),
               patch(Shape::point(), {{kA, kA, kC}}, {{-kMost, -kMost, -kMost}})},
              1 - 0x1p-10};
  EXPECT_EQ(difference(query), "");
}

TEST(LawL8, TheTimeIsNoMoreThanAStepBeforeTheContact) {
  Draw random{Random::keyed({46})};
  int hits = 0;
  for (std::size_t i = 0; i < 2000 / kOneIn; ++i) {
    const Query query = about_origin(random, random.pick(std::array{1, 2, 3, 20}));
    const auto contact = linear::first_contact(query);
    if (!contact) continue;
    ++hits;
    for (const int level : {44, 47, 50}) {
      const Rational toi = exact(first_linear_contact(query, level).toi);
      ASSERT_LE(toi, contact->hi()) << to_json({query, {}, {}, {}});
      const Rational early = exact(query.t_max) * power_of_two(-level) + toi * power_of_two(-48);
      ASSERT_LE(contact->lo(), toi + early) << to_json({query, {}, {}, {}});
    }
  }
  EXPECT_GE(hits, 10);
}

TEST(LawL9, SaysWhatExactArithmeticFinds) {
  Draw random{Random::keyed({47})};
  NormalisedQuery normalised;
  int none = 0, proven = 0;
  for (std::size_t i = 0; i < 4000 / kOneIn; ++i) {
    const Query query = about_origin(random, random.pick(std::array{3, 20, 53}));
    normalise(query, normalised);
    const RoughContact rough = rough_contact(normalised, 0, 0, 0x1p-14);
    if (rough.kind == RoughContact::Kind::kOpen) continue;
    const auto contact = linear::first_contact(query);
    const bool is_proven = rough.kind == RoughContact::Kind::kProven;
    ASSERT_EQ(contact.has_value(), is_proven) << to_json({query, {}, {}, {}});
    ++(is_proven ? proven : none);
    if (!is_proven) continue;
    ASSERT_LE(exact(std::ldexp(rough.time, normalised.time)), contact->hi());
  }
  EXPECT_GT(none, 10);
  EXPECT_GT(proven, 10);
}

// Integers are slow: random queries are not to need them.
TEST(RoughContact, LeavesNoneInAThousandRandomQueriesOpen) {
  Draw random{Random::keyed({38})};
  NormalisedQuery normalised;
  std::size_t open = 0;
  constexpr std::size_t kQueries = 20'000 / kOneIn;
  for (std::size_t i = 0; i < kQueries; ++i) {
    normalise(about_origin(random, 53), normalised);
    open += rough_contact(normalised, 0, 0, 0x1p-14).kind == RoughContact::Kind::kOpen;
  }
  EXPECT_LT(1000 * open, kQueries);
}

// p(t) = (t − ½, ε), q(t) = (s·ε, t − ½) about the origin: collinear with it where (t − ½)² = s·ε²,
// and on opposite sides there.
Query near_roots(int exponent, double s) {
  const double e = std::ldexp(1, exponent);
  return {{patch(Shape::point(), {{0, 0, 0}}),
           patch(Shape::curve(1), {{-0.5, e, 0}, {s * e, -0.5, 0}}, {{1, 0, 0}, {0, 1, 0}})},
          1};
}

TEST(LawL3, PartsRootsThatAreNear) {
  for (const int exponent : {-4, -20, -60, -100, -190}) {
    EXPECT_EQ(kind_of(near_roots(exponent, -1)), Kind::kNone) << exponent;
    EXPECT_EQ(kind_of(near_roots(exponent, 0)), Kind::kProven) << exponent;
    EXPECT_EQ(kind_of(near_roots(exponent, 1)), Kind::kProven) << exponent;
    for (const double s : {-1.0, 0.0, 1.0, 3.0}) EXPECT_EQ(difference(near_roots(exponent, s)), "");
  }
}

/// The same about a triangle: a third corner makes the determinant a polynomial of degree 3.
TEST(LawL4, FindsRepeatedRootsOfCubics) {
  for (const double z : {-1.0, -0.25, 0.0, 0.5}) {
    for (const double s : {-0x1p-60, 0.0, 0x1p-60}) {
      const Query query{{patch(Shape::point(), {{0, 0, 0}}),
                         patch(Shape::triangle(1), {{-0.5, 1, 0}, {s, -0.5, 0}, {-0.25, -0.25, z}},
                               {{1, 0, 0}, {0, 1, 0}, {0.125, -0.375, 0.5}})},
                        1};
      EXPECT_EQ(difference(query), "");
    }
  }
}

/// The face is 2^-places above the point, a corner of it far up, both times a power of two.
Query gap_of_places(int places, double gap, double scale) {
  const double low = std::ldexp(scale, -places);
  return {{patch(Shape::point(), {{0.25, 0.25, low - gap * low}}),
           patch(Shape::triangle(1), {{0, 0, low}, {0, 1, low}, {1, 0, 0.5 * scale}})},
          1};
}

// It is exact for the number of binary places that it promises, from the lowest bit of a coordinate
// to its highest. Beyond, it says hit wherever the bounds of doubles do not exclude one.
TEST(LawL7, IsExactInTheRangeThatItSays) {
  for (int places = 240; places <= 270; ++places) {
    if (places == 255) continue;  // covered here, but not promised
    for (const double scale : {1.0, 0x1p-700, 0x1p700}) {
      const Query apart = gap_of_places(places, 1, scale),
                  touching = gap_of_places(places, 0, scale);
      const bool covered = places <= 254;
      EXPECT_EQ(kind_of(apart), covered ? Kind::kNone : Kind::kTooWide) << places;
      if (covered) {
        EXPECT_EQ(difference(apart), "");
        EXPECT_EQ(difference(touching), "");
      }
      if (places == 254) continue;  // the same of ends
      Query with_ends = apart;
      for (MovingPatch<double>& patch : with_ends.patches) {
        patch.ends = patch.positions;
        patch.velocities.clear();
      }
      EXPECT_EQ(kind_of(with_ends), places <= 253 ? Kind::kNone : Kind::kTooWide) << places;
    }
  }
}

// Advancement stops short of it, so the general search answers.
TEST(LinearContact, AHitBeyondTheRangeSaysThatItIsNotProven) {
  const Query query{
      {patch(Shape::point(), {{-0x1.0cp+0 - 0x1p-46, 0x1.6p-1 - 0x1p-46, 0x1.6p-3 + 0x1p-46}},
             {{0.3125, 1.75, 1.21875}}),
       patch(Shape::triangle(1),
             {{-0.96875, 1.28125, -1.15625},
              {-0.65625, 1.46875, 0.96875},
              {0x1p-300, -1.53125, 1.34375}},
             {{0.34375, -0.875, 1.625}, {-0.65625, 1.625, 1.875}, {0.53125, 1.8125, 0.1875}})},
      1};
  ASSERT_EQ(kind_of(query), Kind::kTooWide);
  const Answer answer = TdibmC().answer(query, {});
  ASSERT_EQ(answer.verdict, Verdict::kHit);
  EXPECT_GT(answer.pops, 0U);
  EXPECT_EQ(answer.note, "contact not proven");
}

TEST(LinearContact, DecidesAtTheEndsOfDoubles) {
  constexpr double kLeast = std::numeric_limits<double>::denorm_min();
  constexpr double kMost = std::numeric_limits<double>::max();
  for (const double t_max : {0.0, kLeast, 1.0, kMost}) {
    for (const double x : {kLeast, 3 * kLeast, 0x1p-1022, kMost}) {
      for (const double v : {0.0, kLeast, -kLeast, -1.0, -kMost, kMost}) {
        const Query query{{patch(Shape::point(), {{0, 0, x}}, {{0, 0, v}}),
                           patch(Shape::triangle(1), {{-1, -1, 0}, {-1, 3, 0}, {3, -1, 0}})},
                          t_max};
        if (kind_of(query) == Kind::kTooWide) continue;
        EXPECT_EQ(difference(query), "");
      }
    }
  }
}

}  // namespace
}  // namespace ccdfuzz::certified
