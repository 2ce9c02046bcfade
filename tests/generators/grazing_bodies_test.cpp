// Bodies that touch without depth, and bodies in the plane z = 0.
#include <gtest/gtest.h>

#include <cmath>

#include "base/nearest_float.hpp"
#include "case/scale.hpp"
#include "certify/checker/check_case.hpp"
#include "certify/oracle/body_depth.hpp"
#include "certify/oracle/oracle.hpp"
#include "generators/bodies.hpp"

namespace ccdfuzz {
namespace {

Case made(Family family, ContactClass contact, std::uint64_t index, bool plane = false,
          std::uint64_t seed = 0) {
  GeneratorOptions options;
  options.family = family;
  options.contact = contact;
  options.plane = plane;
  options.seed = seed;
  Case value = generate(options, index).value;
  EXPECT_TRUE(check_case(value)) << name_of(contact) << ' ' << index;
  EXPECT_TRUE(is_binary32(value.query));
  EXPECT_EQ(is_in_plane(value.query), plane);
  return value;
}

constexpr std::array kPlaneClasses = {ContactClass::kEE, ContactClass::kVE, ContactClass::kVV};

TEST(GrazingBodies, TouchAfterTheStartAndNeverDeeperInAPlaneToo) {
  for (std::uint64_t index = 0; index < 4; ++index) {
    for (const ContactClass contact : kPlaneClasses) {
      const Case value = made(Family::kBodiesGrazing, contact, index, true);
      EXPECT_EQ(value.truth.collides, true);
      EXPECT_GT(value.truth.witness->t, 0);
      EXPECT_EQ(depth_until(value.query, value.query.t_max, true), 0.0);
    }
  }
}

TEST(GrazingBodies, HaveNoFrontInThePlaneOfTheirMotion) {
  EXPECT_FALSE(is_made(Family::kMeshGrazingOneSided, ContactClass::kFF, CaseKind::kRP));
  EXPECT_FALSE(is_made(Family::kMeshGrazingOneSided, ContactClass::kVF, CaseKind::kRN));
  EXPECT_FALSE(is_made(Family::kMeshGrazing, ContactClass::kVF, CaseKind::kNMN));
}

TEST(GrazingBodies, ThatDoNotMoveAgainstEachOtherAreThrownAway) {
  made(Family::kMeshGrazing, ContactClass::kFF, 53, false, 3);
}

/// A rotation about `axis` that is the identity at t. Its angle is up to about a radian.
BodyTurn turn_about(const Vec3<double>& axis, const Vec3<double>& centre, double t) {
  const Vec3<double> d = axis * std::exp2(-1 - std::ceil(std::log2(axis.norm())));
  BodyTurn turn{{}, {}, centre};
  for (const auto& [q, share] : {std::pair(&turn.from, -t), std::pair(&turn.to, 1 - t)}) {
    const Vec3<double> part = share * d;
    *q = {nearest_float(std::sqrt(1 - part.squaredNorm())), part[0], part[1], part[2]};
  }
  return turn;
}

/// Two bodies whose vertices pass through each other at t. They move along the plane between them.
/// One turns or spins about its normal, so that no height above it changes. A turn is the identity
/// at t. A spin is about the vertex that touches, which therefore moves as without it.
struct GrazingTurn {
  Query query;
  Vec3<double> normal;
  Witness witness;
};

std::optional<GrazingTurn> draw_grazing_turn(bool spins, Draw& draw) {
  GeneratorOptions options;
  options.family = Family::kBodiesGrazing;
  options.contact = ContactClass::kVV;
  const auto made = framed_bodies(options, Dyadic(1, -20), draw);
  if (!made || made->truth.witness->t == 1) return std::nullopt;
  GrazingTurn graze{made->query, {0, 0, 0}, *made->truth.witness};
  graze.query.t_max = 1;
  const auto& plane = std::get<BodyClearance>(*made->truth.clearance).normal;
  for (int k = 0; k < 3; ++k) graze.normal[k] = plane[static_cast<size_t>(k)].get_d();
  const size_t side = draw.below(2);
  MovingPatch<double>& body = graze.query.patches[side];
  const auto& weights = graze.witness.weights[side];
  const auto touched = std::ranges::find(weights, Rational(1)) - weights.begin();
  if (spins) {
    const Vec3<double> w = graze.normal / graze.normal.cwiseAbs().maxCoeff();
    body.turn = BodyTurn{{}, {}, body.positions[static_cast<size_t>(touched)], {w[0], w[1], w[2]}};
  } else {
    const Vec3<double> centre = body.positions.back();
    body.turn = turn_about(graze.normal, centre, graze.witness.t.get_d());
  }
  return graze;
}

TEST(GrazingBodies, MayTurnOrSpinAboutTheNormalOfTheirPlane) {
  for (const bool spins : {false, true}) {
    int count = 0;
    for (std::uint64_t seed = 0; seed < 12; ++seed) {
      Draw draw(Random::keyed({seed}));
      const std::optional<GrazingTurn> graze = draw_grazing_turn(spins, draw);
      if (!graze) continue;
      Case touching;
      touching.query = graze->query;
      OracleOptions options;
      options.known = graze->witness;
      touching.truth = decide(graze->query, options).truth;
      EXPECT_EQ(touching.truth.collides, true) << seed;
      EXPECT_TRUE(check_case(touching)) << seed;
      EXPECT_EQ(depth_until(graze->query, 1), 0.0) << seed;
      Case apart;
      apart.query = graze->query;
      for (Vec3<double>& p : apart.query.patches[1].positions) p += graze->normal * 0x1p-12;
      apart.truth = decide(apart.query).truth;
      EXPECT_EQ(apart.truth.collides, false) << seed;
      EXPECT_TRUE(check_case(apart)) << seed;
      ++count;
    }
    EXPECT_GE(count, 4);
  }
}

TEST(BodiesInAPlane, LieAndMoveInItAndSpinAboutItsNormal) {
  for (const ContactClass contact : kPlaneClasses) {
    for (std::uint64_t index = 0; index < 4; ++index) made(Family::kBodies, contact, index, true);
    EXPECT_TRUE(has_spins(made(Family::kSpinning, contact, 0, true).query));
  }
}

}  // namespace
}  // namespace ccdfuzz
