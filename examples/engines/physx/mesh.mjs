// Triangle meshes of PhysX.
import { Refusal } from '../bodies.mjs';

/// top, vector and keep are the adapter's.
export function triangles(physx, top, cooking, { points, mesh: { faces } }, vector, keep) {
  const corners = keep(new physx.PxArray_PxVec3(0)), places = keep(new physx.PxArray_PxU32(0));
  for (const p of points) corners.pushBack(vector(p));
  for (const i of faces.flat()) places.pushBack(i);
  const description = keep(new physx.PxTriangleMeshDesc());
  Object.assign(description.points, { count: points.length, stride: 12, data: corners.begin() });
  Object.assign(description.triangles, { count: faces.length, stride: 12, data: places.begin() });
  const mesh = top.CreateTriangleMesh(cooking, description);
  if (!mesh) throw new Refusal('does not make a mesh of these triangles');
  return keep(new physx.PxTriangleMeshGeometry(mesh));
}
