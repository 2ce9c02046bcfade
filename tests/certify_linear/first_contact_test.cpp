// What linear.decision_is_proven does not draw: a time that is enclosed, and other shapes.
#include "certify/linear/first_contact.hpp"

#include <gtest/gtest.h>

#include "certify/checker/check_linear.hpp"
#include "share.hpp"

namespace ccdfuzz::linear {
namespace {

/// A face that turns about an axis in it; the vertex waits in its way, off the axis.
Query irrational_query() {
  Query query;
  query.patches[0] = {Shape::point(), {{0.5, -0.5, 0.0625}}, {{0, 0, -0.5}}};
  query.patches[1] = {Shape::triangle(1),
                      {{0, -1, -1}, {0, 1, 0}, {2, -1, -2}},
                      {{0, 0, 0}, {0, 0, 1}, {-1, 0, 3}}};
  return query;
}

TEST(FirstContact, AtAnIrrationalTimeIsEnclosedAsTightlyAsAsked) {
  const Query query = irrational_query();
  auto contact = first_contact(query);
  ASSERT_TRUE(contact);
  contact->narrow(power_of_two(-200));
  ASSERT_FALSE(contact->is_rational());
  const Rational lo = contact->lo(), hi = contact->hi();
  EXPECT_LE(Rational(hi - lo), power_of_two(-200));
  EXPECT_TRUE(check_linear_clearance(query, {lo, true}));
  if (kOneIn == 1) {  // halves until it gives up
    EXPECT_FALSE(check_linear_clearance(query, {hi, true}));
  }
  const ContactRoot root{contact->polynomial().coefficients(), lo, hi};
  EXPECT_TRUE(check_contact_root(query, root));
  EXPECT_FALSE(check_contact_root(query, {{}, lo, hi}));
}

TEST(FirstContact, RefusesWhatIsNotLinear) {
  EXPECT_TRUE(is_linear_pair(Shape::point(), Shape::triangle(1)));
  EXPECT_TRUE(is_linear_pair(Shape::curve(1), Shape::curve(1)));
  EXPECT_FALSE(is_linear_pair(Shape::curve(1), Shape::triangle(1)));
  EXPECT_FALSE(is_linear_pair(Shape::curve(2), Shape::curve(1)));
  EXPECT_FALSE(is_linear_pair(Shape::point(), Shape::tensor(1, 1)));
  const MovingPatch<double> face = irrational_query().patches[1];
  const Query query{{face, face}, 1};
  EXPECT_FALSE(check_linear_clearance(query, {Rational(1), true}));
  EXPECT_FALSE(check_contact_root(query, {{Integer(-1), Integer(2)}, 0, 1}));
}

}  // namespace
}  // namespace ccdfuzz::linear
