#include "ccd/certified/linear_advance.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "bezier/blossom.hpp"
#include "ccd/certified/tdibm_c.hpp"
#include "certify/linear/first_contact.hpp"
#include "files/case_json.hpp"
#include "generators/draw/draw.hpp"
#include "share.hpp"

namespace ccdfuzz::certified {
namespace {

/// All bits in use.
double full_double(Draw& random) {
  return std::ldexp(static_cast<double>(random.integer(-(1LL << 53), 1LL << 53)), -53);
}

std::array<Shape, 2> any_linear_shapes(Draw& random) {
  constexpr Shape kPoint = Shape::point(), kEdge = Shape::curve(1), kFace = Shape::triangle(1);
  return random.pick(std::array<std::array<Shape, 2>, 6>{{{kEdge, kEdge},
                                                          {kEdge, kEdge},
                                                          {kPoint, kFace},
                                                          {kFace, kPoint},
                                                          {kPoint, kEdge},
                                                          {kPoint, kPoint}}});
}

/// Two linear patches in full doubles that are within a few floats of touching at t = 1/2: at a
/// corner, on an edge or inside. They may be far from the origin, or have a fast common velocity.
Query almost_touching(Draw& random) {
  const std::array<Shape, 2> shapes = any_linear_shapes(random);
  Query query;
  query.t_max = random.pick(std::array{0.5, 1.0, std::nextafter(0.5, 0), std::nextafter(0.5, 1)});
  const double away = random.pick(std::array{0.0, 0.0, 1.0, 0x1p20});
  const double common = random.pick(std::array{0.0, 0.0, 0x1p10});
  std::array<Vec3<double>, 2> at{};
  for (size_t s = 0; s < 2; ++s) {
    MovingPatch<double>& patch = query.patches[s];
    patch.shape = shapes[s];
    const int count = patch.shape.control_count();
    std::vector<double> weights(static_cast<size_t>(count), 0);
    weights[random.below(weights.size())] = 1;
    if (count > 1 && random.coin()) weights = {0.375, 0.625};
    if (count > 2) weights.resize(3, 0);
    at[s] = {0, 0, 0};
    for (int i = 0; i < count; ++i) {
      Vec3<double> p, v;
      for (int k = 0; k < 3; ++k) {
        p[k] = full_double(random) + away;
        v[k] = full_double(random) + common;
        at[s][k] += weights[static_cast<size_t>(i)] * (p[k] + 0.5 * v[k]);
      }
      patch.positions.push_back(p);
      patch.velocities.push_back(v);
    }
  }
  for (Vec3<double>& p : query.patches[0].positions) {
    for (int k = 0; k < 3; ++k) p[k] += at[1][k] - at[0][k];
  }
  return query;
}

TEST(LinearAdvance, NeverPassesAContact) {
  Draw random{Random::keyed({11})};
  int contacts = 0, clear = 0, reached = 0;
  NormalisedQuery normalised;
  for (size_t i = 0; i < 6000 / kOneIn; ++i) {
    const Query query = almost_touching(random);
    ASSERT_TRUE(is_linear_pair(query.patches[0].shape, query.patches[1].shape));
    auto contact = linear::first_contact(query);
    normalise(query, normalised);
    const Advancement advanced = advance(normalised);
    const bool is_clear = advanced.kind == Advancement::Kind::kClear;
    clear += is_clear;
    if (!contact) continue;
    ++contacts;
    ASSERT_FALSE(is_clear) << to_json({query, {}, {}, {}});
    const Rational time = exact(original_time(advanced.time, normalised.time));
    ASSERT_GE(contact->sign_of(linear::Polynomial({-time.get_num(), time.get_den()})), 0)
        << to_json({query, {}, {}, {}});
    const Rational early = contact->lo() - time;
    reached += advanced.kind == Advancement::Kind::kStopped && early < power_of_two(-20);
  }
  // All of it happens. Where patches turn much, the general search is to do the rest.
  EXPECT_GE(contacts, 600 / static_cast<int>(kOneIn));
  EXPECT_GE(clear, 600 / static_cast<int>(kOneIn));
  EXPECT_GE(10 * reached, contacts);
}

// The nearest point of a resting triangle is on the edge u + v = 1, at parameters that add up to
// more when each is rounded.
TEST(LinearAdvance, StopsAtParametersInTheirDomain) {
  NormalisedQuery normalised;
  const MovingPatch<double> point{Shape::point(), {{0, 0, 0}}, {{0, 0, 0}}};
  MovingPatch<double> face{Shape::triangle(1), {{-1, -1, 0}, {}, {}}, {3, Vec3<double>::Zero()}};
  Draw random{Random::keyed({13})};
  int stopped = 0;
  for (int i = 0; i < 1000; ++i) {
    const double x = std::abs(full_double(random)), y = std::abs(full_double(random));
    face.positions[1] = {x, -y, 0};
    face.positions[2] = {-x, y, 0};
    if (i % 2 != 0) face.positions[2] *= 0.25;
    const Query query{{face, point}, 0};
    normalise(query, normalised);
    const Advancement advanced = advance(normalised);
    if (advanced.kind != Advancement::Kind::kStopped) continue;
    ++stopped;
    ASSERT_TRUE(face.shape.contains(nearest_parameters(normalised, advanced.time)[0]))
        << to_json({query, {}, {}, {}});
  }
  EXPECT_GT(stopped, 900);
}

/// Some parameters all over a linear shape.
std::vector<Uv<double>> grid_of(const Shape& shape) {
  constexpr int kParts = 8;
  std::vector<Uv<double>> grid;
  for (int i = 0; i <= (shape.parameter_count() > 0 ? kParts : 0); ++i) {
    for (int j = 0; j <= (shape.parameter_count() > 1 ? kParts - i : 0); ++j) {
      grid.push_back({static_cast<double>(i) / kParts, static_cast<double>(j) / kParts});
    }
  }
  return grid;
}

// Both orders of the patches: a point has no edge, whichever patch it is. Half of all edges and
// faces have two control points in one place. A quarter of faces have corners that are on a line,
// but for rounding.
TEST(LinearAdvance, FindsParametersOfNearestPoints) {
  constexpr Shape kPoint = Shape::point(), kEdge = Shape::curve(1), kFace = Shape::triangle(1);
  Draw random{Random::keyed({14})};
  NormalisedQuery normalised;
  for (const auto& shapes : {std::array{kEdge, kEdge},
                             {kPoint, kEdge},
                             {kEdge, kPoint},
                             {kPoint, kFace},
                             {kFace, kPoint}}) {
    for (int i = 0; i < 100; ++i) {
      Query query;
      for (size_t s = 0; s < 2; ++s) {
        query.patches[s].shape = shapes[s];
        for (int c = 0; c < shapes[s].control_count(); ++c) {
          Vec3<double> p;
          for (int k = 0; k < 3; ++k) p[k] = full_double(random);
          query.patches[s].positions.push_back(p);
          query.patches[s].velocities.push_back(Vec3<double>::Zero());
        }
        Points<double>& points = query.patches[s].positions;
        const size_t n = points.size(), at = static_cast<size_t>(i / 4) % n;
        if ((i >> s) % 2 == 1) points[at] = points[(at + 1) % n];
        if (n > 2 && i % 4 == 0)
          points[2] = points[0] + full_double(random) * (points[1] - points[0]);
      }
      const auto distance = [&](const Uv<double>& a, const Uv<double>& b) {
        return (evaluate(query.patches[0], a, 0.0) - evaluate(query.patches[1], b, 0.0)).norm();
      };
      normalise(query, normalised);
      const auto [a, b] = nearest_parameters(normalised, 0);
      const double found = distance(a, b);
      for (const Uv<double>& other : grid_of(shapes[0])) {
        for (const Uv<double>& another : grid_of(shapes[1])) {
          ASSERT_LE(found, distance(other, another) + 1e-12) << to_json({query, {}, {}, {}});
        }
      }
    }
  }
}

// The nearest point of the edge is its end, 0.197 away.
TEST(LinearAdvance, KeepsADistanceBeyondTheEndOfAnEdge) {
  const MovingPatch<double> edge{
      Shape::curve(1), {{0, 0, 0}, {1, 0, 0}}, {2, Vec3<double>::Zero()}};
  const MovingPatch<double> point{Shape::point(), {{1.1, 0, 0.17}}, {{0, 1, 0}}};
  for (Query query : {Query{{edge, point}, 0.01}, Query{{point, edge}, 0.01}}) {
    query.separation = 0.19;
    EXPECT_EQ(TdibmC().answer(query, {}).verdict, Verdict::kMiss);
    query.separation = 0.2;
    EXPECT_EQ(TdibmC().answer(query, {}).verdict, Verdict::kHit);
  }
}

TEST(LinearAdvance, TakesLinearShapesAlone) {
  EXPECT_TRUE(is_linear_pair(Shape::point(), Shape::triangle(1)));
  EXPECT_FALSE(is_linear_pair(Shape::curve(1), Shape::triangle(1)));
  EXPECT_FALSE(is_linear_pair(Shape::curve(2), Shape::point()));
  EXPECT_FALSE(is_linear_pair(Shape::point(), Shape::tensor(1, 1)));
}

}  // namespace
}  // namespace ccdfuzz::certified
