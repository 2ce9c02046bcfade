// Named linear queries: what is parallel, coplanar, collinear, tangent, static or of no extent.
#include "certify/linear/first_contact.hpp"
#include "bezier/exact_patch.hpp"

#include <gtest/gtest.h>

#include "certify/checker/check_linear.hpp"
#include "certify/checker/check_witness.hpp"
#include "share.hpp"

namespace ccdfuzz::linear {
namespace {

using Point3 = std::array<double, 3>;

MovingPatch<double> patch(const Shape& shape, const std::vector<Point3>& positions,
                          const std::vector<Point3>& velocities) {
  MovingPatch<double> out{shape, {}, {}};
  for (const Point3& p : positions) out.positions.push_back({p[0], p[1], p[2]});
  for (const Point3& v : velocities) out.velocities.push_back({v[0], v[1], v[2]});
  return out;
}

MovingPatch<double> edge(const Point3& a, const Point3& b, const Point3& va, const Point3& vb) {
  return patch(Shape::curve(1), {a, b}, {va, vb});
}
MovingPatch<double> vertex(const Point3& p, const Point3& v) {
  return patch(Shape::point(), {p}, {v});
}
MovingPatch<double> still_edge(const Point3& a, const Point3& b) {
  return edge(a, b, {0, 0, 0}, {0, 0, 0});
}
MovingPatch<double> still_face(const Point3& a, const Point3& b, const Point3& c) {
  return patch(Shape::triangle(1), {a, b, c}, {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}});
}

const MovingPatch<double> kFace = still_face({0, 0, 0}, {0, 1, 0}, {1, 0, 0});
const MovingPatch<double> kEdge = still_edge({-1, 0, 0}, {1, 0, 0});

struct NamedLinear {
  const char* name;
  MovingPatch<double> a, b;
  /// Rational time of the first contact in [0, 1]; "" for none.
  const char* time;
};

const std::vector<NamedLinear>& named_linear() {
  static const std::vector<NamedLinear> all = {
      {"vertex through a face", vertex({0.25, 0.25, 1}, {0, 0, -3}), kFace, "1/3"},
      {"vertex ends on a face", vertex({0.25, 0.25, 1}, {0, 0, -1}), kFace, "1"},
      {"vertex ends just above", vertex({0.25, 0.25, 1 + 0x1p-52}, {0, 0, -1}), kFace, ""},
      {"vertex starts on a corner and leaves", vertex({1, 0, 0}, {1, 0, 0}), kFace, "0"},
      {"vertex passes beside", vertex({0.5, 0.5 + 0x1p-53, 1}, {0, 0, -2}), kFace, ""},
      {"vertex passes through an edge", vertex({0.5, 0.5, 1}, {0, 0, -2}), kFace, "1/2"},
      {"vertex slides in the plane", vertex({-1, 0.25, 0}, {3, 0, 0}), kFace, "1/3"},
      {"vertex slides past in the plane", vertex({-1, 1 + 0x1p-52, 0}, {3, 0, 0}), kFace, ""},
      {"vertex slides to a corner", vertex({-1, 1, 0}, {2, 0, 0}), kFace, "1/2"},
      {"static vertex in a face", vertex({0.25, 0.25, 0}, {0, 0, 0}), kFace, "0"},
      {"static vertex beside a face", vertex({-0x1p-60, 0.25, 0}, {0, 0, 0}), kFace, ""},
      {"face that is an edge", vertex({0.5, 0, 1}, {0, 0, -2}),
       still_face({0, 0, 0}, {1, 0, 0}, {0.25, 0, 0}), "1/2"},
      {"face that is an edge, missed", vertex({1.5, 0, 1}, {0, 0, -2}),
       still_face({0, 0, 0}, {1, 0, 0}, {0.25, 0, 0}), ""},
      {"face that is a point", vertex({0, 0, 1}, {0, 0, -4}),
       still_face({0, 0, 0}, {0, 0, 0}, {0, 0, 0}), "1/4"},
      {"face that is a point, missed", vertex({0, 0, 1}, {0x1p-60, 0, -4}),
       still_face({0, 0, 0}, {0, 0, 0}, {0, 0, 0}), ""},
      {"crossing edges", edge({0, -1, 1}, {0, 1, 1}, {0, 0, -2}, {0, 0, -2}), kEdge, "1/2"},
      {"crossing edges, end to end", edge({1, 0, 1}, {1, 1, 1}, {0, 0, -2}, {0, 0, -2}), kEdge,
       "1/2"},
      {"edges that pass end by end",
       edge({1 + 0x1p-52, 0, 1}, {1 + 0x1p-52, 1, 1}, {0, 0, -2}, {0, 0, -2}), kEdge, ""},
      {"parallel edges that meet", edge({0, 0, 1}, {3, 0, 1}, {0, 0, -4}, {0, 0, -4}), kEdge,
       "1/4"},
      {"parallel edges side by side", edge({0, 1, 1}, {3, 1, 1}, {0, 0, -4}, {0, 0, -4}), kEdge,
       ""},
      {"collinear edges that meet", edge({3, 0, 0}, {4, 0, 0}, {-4, 0, 0}, {-4, 0, 0}), kEdge,
       "1/2"},
      {"collinear edges apart", edge({3, 0, 0}, {4, 0, 0}, {-1, 0, 0}, {-1, 0, 0}), kEdge, ""},
      {"collinear edges that separate", edge({1, 0, 0}, {2, 0, 0}, {1, 0, 0}, {1, 0, 0}), kEdge,
       "0"},
      {"edges that cross in a plane", edge({0, 1, 0}, {0, 2, 0}, {0, -3, 0}, {0, -3, 0}), kEdge,
       "1/3"},
      {"static crossing edges", still_edge({0, -1, 0}, {0, 1, 0}), kEdge, "0"},
      {"edges of no extent", still_edge({0, 0, 0}, {0, 0, 0}), still_edge({0, 0, 0}, {0, 0, 0}),
       "0"},
      {"edges of no extent that meet", edge({1, 1, 1}, {1, 1, 1}, {-2, -2, -2}, {-2, -2, -2}),
       still_edge({0, 0, 0}, {0, 0, 0}), "1/2"},
      // det = (1/2 − t)², at the crossing of the edges.
      {"double root of edges", edge({0, -1, 0.5}, {0, 1, 0.5}, {0, 0, -1}, {0, 0, -1}),
       edge({-1, 0.5, 0}, {1, -0.5, 0}, {0, -1, 0}, {0, 1, 0}), "1/2"},
  };
  return all;
}

TEST(FirstContact, IsRightForNamedQueries) {
  for (const NamedLinear& named : named_linear()) {
    for (const bool swapped : {false, true}) {
      Query query{{named.a, named.b}, 1};
      if (swapped) std::swap(query.patches[0], query.patches[1]);
      auto contact = first_contact(query);
      const bool touches = *named.time != '\0';
      ASSERT_EQ(contact.has_value(), touches) << named.name;
      if (!touches) {
        EXPECT_TRUE(check_linear_clearance(query, {Rational(1), true})) << named.name;
        continue;
      }
      const Rational time = *parse_rational(named.time);
      contact->time.narrow(power_of_two(-64));
      ASSERT_TRUE(contact->time.is_rational()) << named.name;
      EXPECT_EQ(contact->time.lo(), time) << named.name;
      const Witness witness = witness_of(
          {exact_patch<Rational>(query.patches[0]), exact_patch<Rational>(query.patches[1])},
          *contact);
      const Result<void> checked = check_witness(query, witness);
      EXPECT_TRUE(checked) << named.name << ": " << checked.error().message();
      EXPECT_TRUE(check_linear_clearance(query, {time, false})) << named.name;
      EXPECT_FALSE(check_linear_clearance(query, {time, true})) << named.name;
    }
  }
}

/// A face that turns about an axis in it; the vertex waits in its way, off the axis.
Query irrational_query() {
  const MovingPatch<double> face = patch(Shape::triangle(1), {{0, -1, -1}, {0, 1, 0}, {2, -1, -2}},
                                         {{0, 0, 0}, {0, 0, 1}, {-1, 0, 3}});
  return {{vertex({0.5, -0.5, 0.0625}, {0, 0, -0.5}), face}, 1};
}

TEST(FirstContact, AtAnIrrationalTimeIsEnclosedAsTightlyAsAsked) {
  const Query query = irrational_query();
  auto contact = first_contact(query);
  ASSERT_TRUE(contact);
  contact->time.narrow(power_of_two(-200));
  ASSERT_FALSE(contact->time.is_rational());
  const Rational lo = contact->time.lo(), hi = contact->time.hi();
  EXPECT_LE(Rational(hi - lo), power_of_two(-200));
  EXPECT_TRUE(check_linear_clearance(query, {lo, true}));
  if (kOneIn == 1) {  // halves until it gives up
    EXPECT_FALSE(check_linear_clearance(query, {hi, true}));
  }
  const ContactRoot root{contact->time.polynomial().coefficients(), lo, hi};
  EXPECT_TRUE(check_contact_root(query, root));
  EXPECT_FALSE(check_contact_root(query, {{}, lo, hi}));
}

TEST(FirstContact, RefusesWhatIsNotLinear) {
  EXPECT_TRUE(is_linear(Shape::point(), Shape::triangle(1)));
  EXPECT_TRUE(is_linear(Shape::curve(1), Shape::curve(1)));
  EXPECT_FALSE(is_linear(Shape::curve(1), Shape::triangle(1)));
  EXPECT_FALSE(is_linear(Shape::curve(2), Shape::curve(1)));
  EXPECT_FALSE(is_linear(Shape::point(), Shape::tensor(1, 1)));
  const Query query{{kFace, kFace}, 1};
  EXPECT_FALSE(check_linear_clearance(query, {Rational(1), true}));
  EXPECT_FALSE(check_contact_root(query, {{Integer(-1), Integer(2)}, 0, 1}));
}

}  // namespace
}  // namespace ccdfuzz::linear
