// Meshes of Jolt, and what its shapes need. It rounds their corners to 21 bits of what a mesh extends over, along each axis.
import { Refusal } from '../bodies.mjs';

/// What is asked extends over no more: its numbers are up to 128, or it is so near to its middle.
export const kWidest = 256;
/// Half of such a step, along each of three axes.
export const meshRounding = Math.sqrt(3) * kWidest * 2 ** -22;

/// vector and keep are the adapter's.
export function triangles(Jolt, { points, mesh }, vector, keep) {
  for (const k of [0, 1, 2]) {
    const all = points.map((p) => p[k]);
    if (Math.max(...all) - Math.min(...all) > kWidest) throw new Refusal('rounds wide meshes too much');
  }
  const list = keep(new Jolt.TriangleList());
  for (const face of mesh.faces) list.push_back(keep(new Jolt.Triangle(...face.map((i) => vector(points[i])))));
  const result = keep(new Jolt.MeshShapeSettings(list)).Create();
  if (result.HasError()) throw new Refusal(result.GetError().c_str());
  return result.Get();
}

/// A physics system registers the kinds of shapes; nothing else is asked of this one.
export function registerShapes(Jolt) {
  const settings = new Jolt.JoltSettings();
  settings.mObjectLayerPairFilter = new Jolt.ObjectLayerPairFilterTable(1);
  settings.mBroadPhaseLayerInterface = new Jolt.BroadPhaseLayerInterfaceTable(1, 1);
  settings.mObjectVsBroadPhaseLayerFilter = new Jolt.ObjectVsBroadPhaseLayerFilterTable(
    settings.mBroadPhaseLayerInterface, 1, settings.mObjectLayerPairFilter, 1);
  new Jolt.JoltInterface(settings);
}
