// Certificates M and P, and what they prove: by hand, so that each number is known to be right.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "case/judge.hpp"
#include "certify/checker/check_box.hpp"
#include "certify/checker/check_case.hpp"
#include "certify/checker/check_plane.hpp"
#include "certify/checker/check_truth.hpp"
#include "properties/rising_triangle.hpp"

namespace ccdfuzz {
namespace {

template <class Change>
std::string box_after(const Change& change) {
  ContactBox box = rising_box();
  change(box);
  const auto checked = check_box(rising_triangle().query, box);
  return checked ? "accepted" : checked.error().message();
}

TEST(CheckBox, AcceptsABoxAroundAContact) {
  EXPECT_EQ(box_after([](ContactBox&) {}), "accepted");
  // Any size that fits into the domain: the map is linear.
  for (const double radius : {0x1p-1074, 0x1p-48, 0x1p-2}) {
    EXPECT_EQ(box_after([&](ContactBox& b) { b.radius = {radius, radius, radius}; }), "accepted");
  }
  // Any regular matrix that is near enough.
  EXPECT_EQ(box_after([](ContactBox& b) { b.inverse[0][0] = 0.5; }), "accepted");
  EXPECT_EQ(box_after([](ContactBox& b) { b.inverse[0] = {0.25, 0.25, 0}; }), "accepted");
}

TEST(CheckBox, RefusesABoxThatMayHoldNone) {
  using testing::HasSubstr;
  constexpr const char* kNoChange = "may not change its sign";
  EXPECT_THAT(box_after([](ContactBox& b) { b.centre[4] = std::nextafter(0.5 + 0x1p-10, 1); }),
              HasSubstr(kNoChange));
  EXPECT_THAT(box_after([](ContactBox& b) { b.centre[2] = 0x1p-6; }), HasSubstr(kNoChange))
      << "a fixed unknown counts too";
  EXPECT_THAT(box_after([](ContactBox& b) { b.inverse[0][0] = std::nextafter(0.5, 1); }),
              HasSubstr(kNoChange));
  EXPECT_THAT(box_after([](ContactBox& b) { b.inverse[0][0] = -0.25; }), HasSubstr(kNoChange));
  EXPECT_THAT(box_after([](ContactBox& b) { std::swap(b.inverse[0], b.inverse[1]); }),
              HasSubstr(kNoChange));
  EXPECT_THAT(box_after([](ContactBox& b) {
                b.varied = {0, 1, 2}, b.centre[2] = 0.25;
              }),
              HasSubstr(kNoChange));
}

TEST(CheckBox, RefusesABoxOutsideTheDomain) {
  constexpr const char* kFirst =
      "truth.certificate.contact: the box reaches out of the domain of patches[0], triangle(1)";
  EXPECT_EQ(box_after([](ContactBox& b) { b.radius[0] = std::nextafter(0.25, 1); }), kFirst);
  EXPECT_EQ(box_after([](ContactBox& b) { b.radius[0] = b.radius[1] = 0.25; }), "accepted");
  EXPECT_EQ(box_after([](ContactBox& b) { b.centre[0] = b.centre[1] = 0.5; }), kFirst);
  EXPECT_EQ(box_after([](ContactBox& b) { b.centre[2] = -0x1p-1074; }),
            "truth.certificate.contact: the box reaches out of the domain of patches[1], "
            "triangle(1)");
  EXPECT_EQ(box_after([](ContactBox& b) { b.radius[2] = std::nextafter(0.5, 1); }),
            "truth.certificate.contact: the box reaches before t = 0");
  EXPECT_EQ(box_after([](ContactBox& b) { b.radius[1] = 0; }),
            "truth.certificate.contact: radius: 0 is not > 0");
  EXPECT_EQ(box_after([](ContactBox& b) {
              b.varied = {1, 0, 4};
            }),
            "truth.certificate.contact: varied: not three unknowns in ascending order");
  EXPECT_EQ(box_after([](ContactBox& b) { b.dependent[0] = 3; }), kFirst);
}

/// The other two barycentrics as unknowns, in which the same point is (v, w) or (w, u).
TEST(CheckBox, TakesAnyBarycentricAsTheDependentOne) {
  EXPECT_EQ(box_after([](ContactBox& b) {
              b.dependent[0] = 1;
              b.centre[0] = 0.25, b.centre[1] = 0.5;  // x = 3 − 4v − 4w, y = −1 + 4v
              b.inverse = {{{0, 0.25, 0}, {-0.25, -0.25, 0}, {0, 0, 1}}};
            }),
            "accepted");
  EXPECT_EQ(box_after([](ContactBox& b) {
              b.dependent[0] = 2;
              b.centre[0] = 0.5, b.centre[1] = 0.25;  // x = −1 + 4u, y = 3 − 4w − 4u
              b.inverse = {{{-0.25, -0.25, 0}, {0.25, 0, 0}, {0, 0, 1}}};
            }),
            "accepted");
}

TEST(CheckBox, UnusedParametersAreZeroAndFixed) {
  Query q;
  const Vec3<double> o = {0, 0, 0};
  q.patches[0] = {Shape::point(), {o}, {o}};
  q.patches[1] = {Shape::tensor(1, 1),
                  {{-1, -1, -1}, {-1, 1, -1}, {1, -1, -1}, {1, 1, -1}},
                  {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}, {0, 0, 1}}};
  q.t_max = 2;
  ContactBox box = {{0, 0, 0.5, 0.5, 1},
                    {0, 0},
                    {2, 3, 4},
                    {0.25, 0.25, 0.25},
                    {{{-0.5, 0, 0}, {0, -0.5, 0}, {0, 0, -1}}}};
  EXPECT_TRUE(check_box(q, box));
  box.centre[0] = 0x1p-30;
  EXPECT_FALSE(check_box(q, box));
  box.centre[0] = 0;
  box.dependent[1] = 1;
  EXPECT_FALSE(check_box(q, box));
  box.dependent[1] = 0;
  box.varied = {0, 2, 4};
  EXPECT_FALSE(check_box(q, box));
}

/// A second-order term: the box must be small enough for it, and the checker must count it.
TEST(CheckBox, CountsHigherTerms) {
  Query q;
  const Vec3<double> o = {0, 0, 0};
  // x = 4u² − 1 − wide: the parabola's branch through u = 1/2.
  q.patches[0] = {Shape::curve(2), {{-1, 0, 0}, {-1, 0, 0}, {3, 0, 0}}, {o, o, o}};
  q.patches[1] = {
      Shape::tensor(1, 1), {{0, -1, -1}, {0, 1, -1}, {0, -1, 1}, {0, 1, 1}}, {o, o, o, o}};
  ContactBox box = {{0.5, 0, 0.5, 0.5, 0},
                    {0, 0},
                    {0, 2, 3},
                    {0.25, 0.25, 0.25},
                    {{{0.25, 0, 0}, {0, 0, -0.5}, {0, -0.5, 0}}}};
  EXPECT_TRUE(check_box(q, box));  // |δ²| ≤ 1/16 ≤ 1/4
  box.centre[0] = 0.5 + 0x1p-3;  // value (4·(5/8)² − 1)/4 = 9/64, slope 5/4, second order 1/16
  EXPECT_FALSE(check_box(q, box)) << "9/64 + 1/16 + 1/16 > 1/4";
  box.radius[0] = 0.3125;
  EXPECT_FALSE(check_box(q, box)) << "9/64 + 5/64 + 25/256 > 5/16";
  box.radius[0] = 0.375;
  EXPECT_TRUE(check_box(q, box)) << "9/64 + 6/64 + 9/64 = 3/8";
}

template <class Change>
std::string plane_after(const Change& change) {
  MovingPlane plane = rising_plane();
  change(plane);
  const auto checked = check_plane(rising_triangle().query, plane);
  return checked ? "accepted" : checked.error().message();
}

TEST(CheckPlane, AcceptsThePlaneBetween) {
  EXPECT_EQ(plane_after([](MovingPlane&) {}), "accepted");
  EXPECT_EQ(plane_after([](MovingPlane& p) { p.until = Rational(1, 4); }), "accepted");
  EXPECT_EQ(plane_after([](MovingPlane& p) { p.until = 0; }), "accepted");
  EXPECT_EQ(plane_after([](MovingPlane& p) { p.normal[2] = -7, p.offset = Rational(-7, 2); }),
            "accepted");
}

TEST(CheckPlane, RefusesATiltedOneOneOfNoDirectionAndOneBeforeTheStart) {
  EXPECT_NE(plane_after([](MovingPlane& p) { p.normal[0] = Rational(1, 1000000); }), "accepted");
  EXPECT_NE(plane_after([](MovingPlane& p) { p.normal = {}, p.offset = 0; }), "accepted");
  EXPECT_NE(plane_after([](MovingPlane& p) { p.until = -1; }), "accepted");
}

std::string truth_of(const Case& c) {
  if (auto checked = check_truth(c); !checked) return checked.error().message();
  const auto absent = check_absence(c);
  return absent ? "holds" : absent.error().message();
}

TEST(Certificates, ProveWhatTheCaseSays) {
  Case c = rising_triangle();
  c.truth.clearance = rising_plane();
  EXPECT_EQ(truth_of(c), "holds");
  c.truth.witness.reset();
  c.truth.contact_box = rising_box();
  EXPECT_EQ(truth_of(c), "holds");
  EXPECT_EQ(*c.truth.contact_by(), Rational(1, 2) + Rational(1, 1024));
}

TEST(Certificates, RefuteWhatTheyDoNotProve) {
  Case c = rising_triangle();
  c.truth.clearance = rising_plane();
  c.truth.witness.reset();
  c.truth.contact_box = rising_box();
  Case early = c;
  early.query.t_max = 0.5;
  EXPECT_EQ(truth_of(early),
            "truth.collides: true, but the contact is proven only by t = 513/1024 > t_max");
  Case late = c;
  late.truth.clear_until = Rational(257, 512);
  EXPECT_THAT(truth_of(late), testing::StartsWith("truth.clear_until: 257/512, but the contact box "
                                                  "proves a contact"));
  Case contradicted = c;
  contradicted.truth.collides = false;
  contradicted.truth.proof = "P";
  EXPECT_THAT(truth_of(contradicted), testing::HasSubstr("false, but the contact box proves"));
}

TEST(Certificates, AContactBoxJudges) {
  Case c = rising_triangle();
  c.truth.witness.reset();
  c.truth.contact_box = rising_box();
  const CheckedCase known = checked_or_unknown(c);
  const double by = 0.5 + 0x1p-10;
  EXPECT_EQ(judge(known, Answer::miss()), Outcome::kMissed);
  EXPECT_EQ(judge(known, Answer::hit(by)), Outcome::kCorrect);
  EXPECT_EQ(judge(known, Answer::hit(std::nextafter(by, 1))), Outcome::kLate);
  EXPECT_EQ(with_t_max(c, 0.5).truth.collides, std::nullopt);
  EXPECT_EQ(with_t_max(c, 0.75).truth.collides, true);
}

}  // namespace
}  // namespace ccdfuzz
