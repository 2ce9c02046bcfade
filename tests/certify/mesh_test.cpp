// Certificates W and F of meshes, by hand, so that each number is known to be right.
#include <gtest/gtest.h>

#include "case/judge.hpp"
#include "case/mesh.hpp"
#include "certify/checker/check_case.hpp"
#include "certify/checker/check_truth.hpp"
#include "changed.hpp"

namespace ccdfuzz {
namespace {

/// A ball of radius 1 falls at speed 1 into a valley between two triangles, y = 3|x|/4, that share
/// the edge x = y = 0. Their fronts look up. It starts above the first, and touches that at t = 1.
Query ball_into_valley() {
  Query query;
  auto& [mesh, ball] = query.patches;
  mesh = {Shape::hull(4), {{0, 0, -8}, {0, 0, 8}, {4, 3, 0}, {-4, 3, 0}}, {{0, 0, 0}}};
  mesh.faces = {{0, 1, 2}, {1, 0, 3}};
  ball = {Shape::hull(1), {{2, 3.75, 0}}, {{0, -1, 0}}};
  ball.radius = 1;
  query.t_max = 4;
  return query;
}

MeshClearance valley_clearance() {
  return {1, {{-3, 4, 0}, {3, 4, 0}}, false};
}

bool mesh_clearance_holds(const auto& change) {
  const auto check = [](const auto&... given) { return check_clearance(given...); };
  return holds_changed(ball_into_valley(), valley_clearance(), check, change);
}

void turn_round(Face& face) {
  std::swap(face[1], face[2]);
}

TEST(CheckMesh, AFaceAlongTheMotionIsNotThereWhereOneSided) {
  Query query = ball_into_valley();
  query.patches[0].one_sided = true;
  EXPECT_EQ(faces_there(query), (std::vector<size_t>{0, 1}));
  query.patches[1].velocities[0] = {-4, -3, 0};
  EXPECT_EQ(faces_there(query), (std::vector<size_t>{1}));
  query.patches[0].velocities[0] = {-4, -3, 0};
  EXPECT_TRUE(faces_there(query).empty());
  query.patches[0].one_sided = false;
  EXPECT_EQ(faces_there(query), (std::vector<size_t>{0, 1}));
}

TEST(CheckMesh, ANormalForEachFaceThatIsThereProvesAbsence) {
  EXPECT_TRUE(mesh_clearance_holds([](Query&, MeshClearance&) {}));
  EXPECT_TRUE(
      mesh_clearance_holds([](Query& q, MeshClearance&) { q.patches[0].one_sided = true; }));
  EXPECT_TRUE(mesh_clearance_holds([](Query& q, MeshClearance& c) {
    q.patches[0].one_sided = true;
    turn_round(q.patches[0].faces[0]);
    c.normals.erase(c.normals.begin());
    c.until = 1 + Rational(1, 1000);
  }));
  EXPECT_TRUE(mesh_clearance_holds([](Query& q, MeshClearance& c) {
    q.patches[0].one_sided = true;
    for (Face& face : q.patches[0].faces) turn_round(face);
    c = {4, {}, true};
  })) << "it comes from behind";
  EXPECT_FALSE(mesh_clearance_holds([](Query&, MeshClearance& c) { c.until = -1; }));
  EXPECT_FALSE(mesh_clearance_holds(
      [](Query&, MeshClearance& c) { std::swap(c.normals[0], c.normals[1]); }));
  EXPECT_FALSE(mesh_clearance_holds([](Query&, MeshClearance& c) { c = {0, {}, true}; }));
  EXPECT_FALSE(mesh_clearance_holds(
      [](Query& q, MeshClearance&) { std::swap(q.patches[0], q.patches[1]); }));
  EXPECT_FALSE(mesh_clearance_holds([](Query& q, MeshClearance&) { q.patches[0].faces.clear(); }))
      << "faces prove nothing of a hull";
}

TEST(CheckMesh, AHitIsFalseOnlyFarFromEveryFace) {
  Case known{ball_into_valley(), {}, {}, {}, {}};
  known.query.t_max = 0.5;
  known.truth.collides = false;
  known.truth.proof = "F";
  known.truth.clearance = valley_clearance();
  const auto checked = check_case(known);
  ASSERT_TRUE(checked);
  const Answer hit = Answer::hit(0.25);
  AnswerTerms terms;
  terms.space_tolerance = 0.125;
  EXPECT_EQ(judge(*checked, hit, terms), Outcome::kFalsePositive);
  terms.space_tolerance = 1;
  EXPECT_EQ(judge(*checked, hit, terms), Outcome::kUnknown);
}

/// What is wrong with one is told by tests/golden/malformed.txt.
TEST(CheckMesh, WhatIsNoMeshIsInvalid) {
  Query query = ball_into_valley();
  query.patches[0].faces[1][0] = 4;
  EXPECT_FALSE(is_valid(query));
  query.patches[1] = query.patches[0] = ball_into_valley().patches[0];
  EXPECT_FALSE(is_valid(query)) << "two meshes";
}

}  // namespace
}  // namespace ccdfuzz
