// Triangle meshes of Bullet.
#pragma once

#include <BulletCollision/CollisionDispatch/btCollisionObject.h>
#include <BulletCollision/CollisionDispatch/btCollisionWorld.h>
#include <BulletCollision/CollisionShapes/btBvhTriangleMeshShape.h>
#include <BulletCollision/CollisionShapes/btTriangleMesh.h>

#include "shapes.hpp"

/// The share of the step after which a hull hits a mesh, as the mesh sees it move; below 0: it does
/// not. The mesh has no margin.
inline double swept(const ccdfuzz_patch& body, const ccdfuzz_patch& mesh, double t_max) {
  btTriangleMesh triangles;
  for (std::uint64_t i = 0; i < mesh.face_count; ++i) {
    const auto& [a, b, c] = mesh.faces[i];
    triangles.addTriangle(vector(mesh.positions[a]), vector(mesh.positions[b]),
                          vector(mesh.positions[c]));
  }
  btBvhTriangleMeshShape target(&triangles, true);
  target.setMargin(0);
  btCollisionObject object;
  object.setCollisionShape(&target);
  const btConvexHullShape shape = hull(body);
  double way[3];
  for (int k = 0; k < 3; ++k) way[k] = t_max * (body.velocities[0][k] - mesh.velocities[0][k]);
  const btTransform from(btQuaternion::getIdentity(), middle(body));
  const btTransform to(from.getBasis(), middle(body) + vector(way));
  btCollisionWorld::ClosestConvexResultCallback first(from.getOrigin(), to.getOrigin());
  btCollisionWorld::objectQuerySingle(&shape, from, to, &object, &target, from, first, 0);
  return first.hasHit() ? double{first.m_closestHitFraction} : -1;
}
