// Certificates W and K of bodies, by hand, so that each number is known to be right.
#include <gtest/gtest.h>

#include "certify/checker/check_truth.hpp"
#include "certify/checker/check_witness.hpp"
#include "changed.hpp"

namespace ccdfuzz {
namespace {

/// A ball of radius 1 falls at speed 1 onto a box, whose top is at y = 1, from y = 3: contact at 1.
Query ball_on_box() {
  Query query;
  auto& [box, ball] = query.patches;
  box.shape = Shape::hull(8);
  for (int i = 0; i < 8; ++i) {
    box.positions.emplace_back(i & 1 ? 5 : -5, i & 2 ? 1 : -1, i & 4 ? 5 : -5);
  }
  box.velocities = {{0, 0, 0}};
  ball = {Shape::hull(1), {{-4, 3, 0}}, {{0, -1, 0}}};
  ball.radius = 1;
  query.t_max = 4;
  return query;
}

Witness ball_witness() {
  Witness witness{1, {}};
  witness.weights[0].assign(8, 0);
  witness.weights[0][2] = witness.weights[0][6] = Rational(9, 20);
  witness.weights[0][3] = witness.weights[0][7] = Rational(1, 20);
  witness.weights[1] = {1};
  return witness;
}

const Rational kLittle(1, 1000000);

bool contact_holds(const auto& change) {
  const auto check = [](const auto&... given) { return check_contact(given...); };
  return holds_changed(ball_on_box(), ball_witness(), check, change);
}

TEST(CheckBodies, AContactIsTwoPointsOfTheHullsWithinTheReach) {
  EXPECT_TRUE(contact_holds([](Query&, Witness&) {}));
  EXPECT_TRUE(contact_holds([](Query&, Witness& w) { w.t = 2; }));
  EXPECT_FALSE(contact_holds([](Query&, Witness& w) { w.t -= kLittle; }));
  EXPECT_FALSE(contact_holds([](Query& q, Witness&) { q.patches[1].radius = 1 - 0x1p-53; }));
  // A radius of the other and a separation add to the reach.
  EXPECT_TRUE(contact_holds([](Query& q, Witness& w) {
    q.patches[1].radius = 0.5, q.patches[0].radius = 0.25, q.separation = 0.25;
    w.t = 1;
  }));
  EXPECT_FALSE(contact_holds([](Query& q, Witness&) {
    q.patches[1].radius = 0.5, q.patches[0].radius = 0.25, q.separation = 0.25 - 0x1p-54;
  }));
}

TEST(CheckBodies, ForgedWeightsAreRefused) {
  EXPECT_FALSE(contact_holds([](Query&, Witness& w) { w.weights[0].pop_back(); }));
  EXPECT_FALSE(contact_holds([](Query&, Witness& w) { w.weights = {}; }));
  EXPECT_FALSE(contact_holds([](Query&, Witness& w) { w.t = -1; }));
  EXPECT_FALSE(contact_holds([](Query& q, Witness& w) {
    for (MovingPatch<double>& p : q.patches) p = {Shape::point(), {{0, 0, 0}}, {{0, 0, 0}}};
    w.weights = {{{1}, {1}}};
  })) << "weights are of bodies alone";
}

bool clearance_holds(const auto& change) {
  const auto check = [](const auto&... given) { return check_clearance(given...); };
  return holds_changed(ball_on_box(), BodyClearance{1, {0, 1, 0}, false}, check, change);
}

TEST(CheckBodies, ForgedDirectionsAreRefused) {
  EXPECT_FALSE(clearance_holds([](Query&, BodyClearance& c) { c.normal[1] = -1; }));
  EXPECT_FALSE(clearance_holds([](Query&, BodyClearance& c) { c.normal = {}; }));
  EXPECT_FALSE(clearance_holds([](Query&, BodyClearance& c) { c.normal[0] = kLittle; }));
  EXPECT_FALSE(clearance_holds([](Query&, BodyClearance& c) { c.until = -1; }));
  EXPECT_FALSE(clearance_holds([](Query& q, BodyClearance&) { q.separation = 0x1p-60; }));
  // They are apart at the end, but not from the start.
  EXPECT_FALSE(clearance_holds([](Query& q, BodyClearance&) {
    q.patches[1].positions[0] = {-4, 1, 0}, q.patches[1].velocities[0] = {0, 4, 0};
  }));
}

TEST(CheckBodies, ProofsOfPatchesProveNothingOfBodiesNorTheOtherWayRound) {
  const Query bodies = ball_on_box();
  EXPECT_FALSE(check_clearance(bodies, MovingPlane{Rational(1, 2), {0, -1, 0}, 0}));
  EXPECT_FALSE(check_clearance(bodies, MissTree{Rational(1, 2), {}}));
  EXPECT_FALSE(check_clearance(bodies, LinearClearance{Rational(1, 2), false}));
  Query points;
  points.patches[0] = {Shape::point(), {{0, 0, 0}}, {{0, 0, 0}}};
  points.patches[1] = {Shape::point(), {{0, 3, 0}}, {{0, 0, 0}}};
  EXPECT_FALSE(check_clearance(points, BodyClearance{1, {0, 1, 0}, true}));
  Case known{bodies, {}, {}};
  known.truth.contact_root = ContactRoot{{-1, 1}, 0, 2};
  EXPECT_FALSE(check_truth(known));
}

}  // namespace
}  // namespace ccdfuzz
