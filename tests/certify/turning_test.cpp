// Certificates W and N of bodies that turn, by hand, so that each number is known to be right.
#include <gtest/gtest.h>

#include "case/judge.hpp"
#include "certify/checker/check_case.hpp"
#include "certify/checker/check_truth.hpp"
#include "certify/checker/check_witness.hpp"

namespace ccdfuzz {
namespace {

const BodyTurn kQuaternion{{1, 0, 0, 0}, {1, 0, 0, 1}};
const BodyTurn kAngle{{10, 0}, {2, 16}};

/// A rod of length 2 from the origin turns about it, from the x axis towards the y axis. At t = 1/2
/// it has turned to (3, 4)/5, where a resting point is half way along it.
Query rod_to_point(const BodyTurn& turn) {
  Query query;
  auto& [rod, point] = query.patches;
  rod = {Shape::hull(2), {{0, 0, 0}, {2, 0, 0}}, {{0, 0, 0}}};
  rod.turn = turn;
  point = {Shape::hull(1), {{0.75, 1, 0}}, {{0, 0, 0}}};
  return query;
}

Witness rod_witness() {
  Witness witness{Rational(1, 2), {}};
  witness.weights = {{{Rational(3, 8), Rational(5, 8)}, {1}}};
  return witness;
}

/// The rod's normal at t = 0 and at t = 1/4.
BodyPlanes rod_planes(const BodyTurn& turn) {
  BodyPlanes out{Rational(1, 4), {{0, {}, {Rational(1, 8), Rational(1, 8)}, Rational(1, 8)}}};
  out.planes[0].normals[0] = {0, 1, 0};
  // The angle's tangent is 8/15, or 4/8.
  out.planes[0].normals[1] = {turn.is_quaternion() ? Rational(-8, 15) : Rational(-1, 2), 1, 0};
  return out;
}

const Rational kTiny(1, 1000000);

class CheckTurning : public testing::TestWithParam<bool> {
 protected:
  static const BodyTurn& turn() { return GetParam() ? kQuaternion : kAngle; }

  template <class Change>
  static bool contact_holds(const Change& change) {
    Query query = rod_to_point(turn());
    Witness witness = rod_witness();
    change(query, witness);
    return is_valid(query) && check_contact(query, witness).has_value();
  }
  template <class Change>
  static bool clearance_holds(const Change& change) {
    Query query = rod_to_point(turn());
    BodyPlanes clearance = rod_planes(turn());
    change(query, clearance);
    return is_valid(query) && check_clearance(query, clearance).has_value();
  }
};
INSTANTIATE_TEST_SUITE_P(Turns, CheckTurning, testing::Bool());

TEST_P(CheckTurning, AContactIsOfTurnedPoints) {
  EXPECT_TRUE(contact_holds([](Query&, Witness&) {}));
  EXPECT_FALSE(contact_holds([](Query&, Witness& w) { w.t -= kTiny; }));
  EXPECT_FALSE(contact_holds([](Query&, Witness& w) { w.t += kTiny; }));
  EXPECT_FALSE(contact_holds([](Query& q, Witness&) { q.patches[0].turn.reset(); }));
  EXPECT_FALSE(contact_holds([](Query& q, Witness&) { q.patches[0].turn->centre[0] = 0x1p-30; }));
  EXPECT_FALSE(contact_holds([](Query& q, Witness&) { q.patches[0].turn->to.back() += 0x1p-30; }));
  EXPECT_FALSE(contact_holds([](Query& q, Witness&) { q.patches[1].velocities[0][2] = 0x1p-30; }));
  // The length of q does not matter.
  EXPECT_TRUE(contact_holds([](Query& q, Witness&) {
    for (double& x : q.patches[0].turn->from) x *= 8;
    for (double& x : q.patches[0].turn->to) x *= 8;
  }));
  // About another centre it comes elsewhere, where the other is moved along.
  EXPECT_TRUE(contact_holds([](Query& q, Witness&) {
    for (Vec3<double>& p : q.patches[0].positions) p += Vec3<double>(5, 6, 7);
    q.patches[0].turn->centre = {5, 6, 7};
    q.patches[0].velocities[0] = {2, 0, 0};
    q.patches[1].positions[0] += Vec3<double>(6, 6, 7);
  }));
}

TEST_P(CheckTurning, ATimePastOneIsRefused) {
  EXPECT_FALSE(contact_holds([](Query& q, Witness& w) { q.separation = 8, w.t = 1 + kTiny; }));
  EXPECT_FALSE(clearance_holds([](Query& q, BodyPlanes& c) {
    q.patches[1].positions[0] = {0, 64, 0}, c.until = 1 + kTiny;
  }));
  EXPECT_FALSE(contact_holds([](Query& q, Witness&) { q.t_max = 1 + 0x1p-52; }));
}

TEST(CheckTurning, ATimeOfNoRationalPointsNeedsRoomForThemOfAnAngleAlone) {
  for (const BodyTurn& turn : {kQuaternion, kAngle}) {
    Query query = rod_to_point(turn);
    Witness witness = rod_witness();
    witness.t = Rational(1, 3);
    query.patches[1] = query.patches[0];
    witness.weights[1] = witness.weights[0];
    EXPECT_EQ(check_contact(query, witness).has_value(), turn.is_quaternion());
    query.separation = 0x1p-130;
    EXPECT_TRUE(check_contact(query, witness));
  }
}

TEST_P(CheckTurning, PlanesBetweenThemProveAbsence) {
  EXPECT_TRUE(clearance_holds([](Query&, BodyPlanes&) {}));
  EXPECT_TRUE(clearance_holds([](Query&, BodyPlanes& c) { c.until = Rational(1, 8); }));
  EXPECT_TRUE(clearance_holds([](Query&, BodyPlanes& c) { c.until = 0; }));
  EXPECT_TRUE(clearance_holds([](Query& q, BodyPlanes&) { q.separation = 0.09375; }));
  EXPECT_TRUE(clearance_holds([](Query&, BodyPlanes& c) {
    c.planes.push_back(c.planes[0]);
    c.planes[1].from = Rational(1, 8);
    c.planes[1].normals[0] = {Rational(-1, 4), 1, 0};
    c.planes[0].normals[1] = {Rational(-1, 4), 1, 0};
  }));
}

TEST_P(CheckTurning, AHitIsFalseOnlyWhereThePlaneShowsThemFar) {
  Case known{rod_to_point(turn()), {}, {}, {}, {}};
  known.query.t_max = 0.25;
  known.truth.collides = false;
  known.truth.proof = "N";
  known.truth.clearance = rod_planes(turn());
  const auto checked = check_case(known);
  ASSERT_TRUE(checked) << checked.error().message();
  const auto outcome = [&](double toi, double tolerance) {
    AnswerTerms terms;
    terms.space_tolerance = tolerance;
    return judge(*checked, Answer::hit(toi), terms);
  };
  // The gap is 1/8, and the normal's length 1 at first and above 1.1 in the end.
  EXPECT_EQ(outcome(0, 0.1249), Outcome::kFalsePositive);
  EXPECT_EQ(outcome(0, 0.125), Outcome::kUnknown);
  EXPECT_EQ(outcome(0.25, 0.11), Outcome::kFalsePositive);
  EXPECT_EQ(outcome(0.25, 0.1125), Outcome::kUnknown);
}

TEST_P(CheckTurning, ForgedPlanesAreRefused) {
  EXPECT_FALSE(clearance_holds([](Query&, BodyPlanes& c) { c.until = Rational(1, 2); }));
  EXPECT_FALSE(clearance_holds([](Query&, BodyPlanes& c) { c.planes[0].normals[1] = {0, 1, 0}; }));
  EXPECT_FALSE(clearance_holds([](Query&, BodyPlanes& c) { c.planes[0].normals = {}; }));
  EXPECT_FALSE(clearance_holds([](Query&, BodyPlanes& c) { c.planes[0].gap = 0; }));
  EXPECT_FALSE(clearance_holds([](Query&, BodyPlanes& c) { c.planes[0].gap = 1; }));
  EXPECT_FALSE(clearance_holds([](Query&, BodyPlanes& c) { c.planes[0].offsets[0] = 1; }));
  EXPECT_FALSE(clearance_holds([](Query&, BodyPlanes& c) { c.planes[0].offsets[1] = -kTiny; }));
  EXPECT_FALSE(clearance_holds([](Query&, BodyPlanes& c) { c.planes[0].from = kTiny; }));
  EXPECT_FALSE(clearance_holds([](Query&, BodyPlanes& c) { c.planes.clear(); }));
  EXPECT_FALSE(clearance_holds([](Query&, BodyPlanes& c) {
    c.planes.push_back(c.planes[0]);
    c.planes[1].from = 1;
  })) << "the second ends before it begins";
  EXPECT_FALSE(clearance_holds([](Query& q, BodyPlanes&) { q.separation = 0.125; }))
      << "the gap is no longer than the reach";
  EXPECT_FALSE(clearance_holds([](Query& q, BodyPlanes&) { q.patches[0].turn->to.back() *= 4; }));
  EXPECT_FALSE(
      clearance_holds([](Query& q, BodyPlanes&) { std::swap(q.patches[0], q.patches[1]); }));
}

TEST_P(CheckTurning, NoOtherProofIsOfBodiesThatTurn) {
  const Query turning = rod_to_point(turn());
  EXPECT_FALSE(check_clearance(turning, BodyClearance{Rational(1, 8), {0, 1, 0}, true}));
  EXPECT_FALSE(check_clearance(turning, MissTree{Rational(1, 8), {}}));
  Case known{turning, {}, {}};
  known.truth.collides = true;
  known.truth.witness = rod_witness();
  known.truth.clear_until = Rational(1, 4);
  known.truth.clearance = rod_planes(turn());
  const auto checked = check_case(known);
  ASSERT_TRUE(checked) << checked.error().message();
  EXPECT_EQ(checked->with_t_max(0.25).collides(), false);
}

TEST(CheckTurning, ATurnThatComesThroughZeroIsInvalid) {
  Query query = rod_to_point(kAngle);
  query.patches[0].turn->to = {-1, 16};
  EXPECT_EQ(fault_of(query)->where, "patches[0].turn.to");
  query.patches[0].turn = kAngle;
  query.patches[0].turn->centre[2] = HUGE_VAL;
  EXPECT_EQ(fault_of(query)->where, "patches[0].turn.centre[2]");
  query.patches[0].turn = kAngle;
  EXPECT_TRUE(is_valid(query));
  query.patches[1].turn = kQuaternion;
  EXPECT_TRUE(is_valid(query));
}

BodyTurn spin_of(double x, double y, double z) {
  return {{}, {}, {0, 0, 0}, {x, y, z}};
}

/// A rod of length 2 from the origin spins about the z axis, and a small ball is where its middle
/// comes after so many radians.
Query rod_to_ball(double radians, double cosine, double sine) {
  Query query = rod_to_point(spin_of(0, 0, radians));
  query.patches[1].positions[0] = {cosine, sine, 0};
  query.patches[1].radius = 0x1p-50;
  return query;
}

TEST(CheckSpin, APointIsWhereItsAngleBringsIt) {
  struct Known {
    double radians, cosine, sine;
  };
  for (const auto& [radians, cosine, sine] : {Known{1, 0.54030230586813972, 0.84147098480789651},
                                              Known{-2, -0.41614683654714239, -0.90929742682568169},
                                              Known{8, -0.14550003380861354, 0.98935824662338181},
                                              Known{0x1p-60, 1, 0x1p-60}, Known{0, 1, 0}}) {
    const Query query = rod_to_ball(radians, cosine, sine);
    ASSERT_TRUE(is_valid(query));
    Witness witness{1, {}, {{{Rational(1, 2), Rational(1, 2)}, {1}}}};
    EXPECT_TRUE(check_contact(query, witness)) << radians;
    witness.t = 1 - power_of_two(-30);
    EXPECT_EQ(check_contact(query, witness).has_value(), radians < 1 && radians >= 0) << radians;
    witness = {
        1, {}, {{{Rational(1, 2) + power_of_two(-40), Rational(1, 2) - power_of_two(-40)}, {1}}}};
    EXPECT_FALSE(check_contact(query, witness)) << radians;
  }
}

TEST(CheckSpin, AboutAnyAxisAThirdOfATurnPermutesTheOthers) {
  // 2π/3 about (1, 1, 1) brings the x axis to the y axis.
  const double part = 1.2091995761561452;
  Query query = rod_to_ball(0, 0, 1);
  query.patches[0].turn = spin_of(part, part, part);
  const Witness witness{1, {}, {{{Rational(1, 2), Rational(1, 2)}, {1}}}};
  EXPECT_TRUE(check_contact(query, witness));
  query.patches[0].turn = spin_of(-part, -part, -part);
  EXPECT_FALSE(check_contact(query, witness));
  query.patches[1].positions[0] = {0, 0, 1};
  EXPECT_TRUE(check_contact(query, witness));
}

TEST(CheckSpin, WhatHasNotTurnedIsExactlyWhereItWas) {
  Query query = rod_to_ball(1, 1, 0);
  query.patches[1].radius = 0;
  Witness witness{0, {}, {{{Rational(1, 2), Rational(1, 2)}, {1}}}};
  EXPECT_TRUE(check_contact(query, witness));
  query.patches[0].turn = spin_of(0, -0.0, 0);
  witness.t = 1;
  EXPECT_TRUE(check_contact(query, witness));
  // A rotation by any other angle is rounded.
  query.patches[0].turn = spin_of(0x1p-1000, 0, 0);
  EXPECT_EQ(check_contact(query, witness).error().what,
            "are not seen to touch: the error of a turn exceeds the reach and both radii inside");
}

/// A box and a point in it. The middle of the box, as its corners make it, has the ball of the
/// radius 1/8·2/√3 = 0.1443 in the simplex of the first corners that span a volume.
TEST(CheckSpin, HullsTouchWhereOneHasABallAboutItsPoint) {
  Query query;
  auto& [box, point] = query.patches;
  box = {Shape::hull(8), {}, {{0, 0, 0}}};
  for (int i = 0; i < 8; ++i) {
    box.positions.emplace_back(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
  }
  box.turn = spin_of(1, 2, -3);
  point = {Shape::hull(1), {{0.140625, 0, 0}}, {{0, 0, 0}}};
  Witness witness{Rational(1, 3), {}, {{std::vector<Rational>(8, Rational(1, 8)), {1}}}};
  EXPECT_TRUE(check_contact(query, witness));
  point.positions[0][0] = 0.1484375;
  EXPECT_FALSE(check_contact(query, witness));
  point.radius = 0.0078125;
  EXPECT_TRUE(check_contact(query, witness));
  std::swap(box, point);
  std::swap(witness.weights[0], witness.weights[1]);
  EXPECT_TRUE(check_contact(query, witness));
  // Without a volume or a weight > 0 there is no ball.
  query.patches[0].radius = 0;
  query.patches[0].positions[0] = {0.0625, 0, 0};
  EXPECT_TRUE(check_contact(query, witness));
  for (size_t i = 0; i < 8; ++i) witness.weights[1][i] = i == 0 || i == 7 ? Rational(1, 2) : 0;
  EXPECT_FALSE(check_contact(query, witness));
  witness.weights[1].assign(8, Rational(1, 8));
  for (Vec3<double>& p : query.patches[1].positions) p[2] = 0;
  EXPECT_FALSE(check_contact(query, witness));
}

TEST(CheckSpin, ASpinThatIsTooFastOrBesideATurnIsInvalid) {
  Query query = rod_to_point(spin_of(0, 8, 0));
  EXPECT_TRUE(is_valid(query));
  query.t_max = 2;
  EXPECT_EQ(fault_of(query)->message(), "t_max: 2 is past 1, where a spin ends");
  query.t_max = 1;
  query.patches[0].turn->spin[0] = 0x1p-40;
  EXPECT_EQ(fault_of(query)->where, "patches[0].spin.velocity");
  query.patches[0].turn->spin = {1, 2, HUGE_VAL};
  EXPECT_EQ(fault_of(query)->where, "patches[0].spin.velocity[2]");
  query.patches[0].turn = kQuaternion;
  query.patches[0].turn->spin = {1, 2, 3};
  EXPECT_FALSE(is_valid(query));
  query.patches[0].turn = spin_of(0, 0, 1);
  query.t_max = 1 + 0x1p-52;
  EXPECT_FALSE(is_valid(query));
}

TEST(Work, FractionsTakeTheWordsOfRationals) {
  for (const long divisor : {1L, 3L, 0x7fff'ffff'ffff'ffffL}) {
    for (const long number : {0L, 1L, -5L, 0x7fff'ffff'ffff'fffeL}) {
      for (long exponent = -130; exponent <= 130; ++exponent) {
        const Rational x = Rational(number) / divisor * power_of_two(exponent);
        ASSERT_EQ(words_of(Fraction(x)), words_of(x)) << x;
      }
    }
  }
}

}  // namespace
}  // namespace ccdfuzz
