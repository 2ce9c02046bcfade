// Rapier (npm @dimforge/rapier3d-compat): the time of impact of two shapes, by castShape.
import RAPIER from '@dimforge/rapier3d-compat';

import { Refusal, ball, capsule, promiseOf, serve } from '../bodies.mjs';

const quiet = console.warn;
console.warn = () => {};
await RAPIER.init();
console.warn = quiet;

const vector = ([x, y, z]) => ({ x, y, z });
const isCapsule = ({ points, radius }) => points.length === 2 && radius > 0;
function turn(body) {
  const [x, y, z, w] = isCapsule(body) ? capsule(body, 1).turn : [0, 0, 0, 1];
  return { x, y, z, w };
}

function shape(body) {
  const { points, radius, half, mesh } = body;
  if (mesh) return new RAPIER.TriMesh(new Float32Array(points.flat()), new Uint32Array(mesh.faces.flat()));
  const corners = points.map(vector);
  if (points.length === 1) {
    if (!(radius > 0)) throw new Refusal('has no shape of one point without a radius');
    return new RAPIER.Ball(radius);
  }
  if (isCapsule(body)) return new RAPIER.Capsule(capsule(body, 1).half, radius);
  if (points.length === 2) return new RAPIER.Segment(...corners);
  if (points.length === 3) {
    return radius === 0 ? new RAPIER.Triangle(...corners) : new RAPIER.RoundTriangle(...corners, radius);
  }
  if (half) return radius === 0 ? new RAPIER.Cuboid(...half) : new RAPIER.RoundCuboid(...half, radius);
  const all = new Float32Array(points.flat());
  const hull = radius === 0 ? new RAPIER.ConvexPolyhedron(all, null) : new RAPIER.RoundConvexPolyhedron(all, null, radius);
  const raw = hull.intoRaw();
  if (!raw) throw new Refusal('makes no hull of these corners');
  raw.free();
  return hull;
}

const still = vector([0, 0, 0]);
// The target distance, 0, came with version 0.13.
const distance = RAPIER.Shape.prototype.castShape.length < 10 ? [] : [0];
// It states no tolerance. Versions before 0.20 stay within this one.
const promise = promiseOf(import.meta.url);
const overlap = promiseOf(import.meta.url, 'overlap.json');
const bodies = [ball, { least_points: 2, most_points: 12 }];
const hello = { name: 'Rapier', version: RAPIER.version(), promise, overlap, tolerance: 1e-4, bodies, sides: [2], far: 16 };
await serve(hello, (a, b, way) => {
  const hit = shape(a).castShape(vector(a.centre), turn(a), vector(way), shape(b), vector(b.centre),
                                 turn(b), still, ...distance, 1, true);
  return hit?.time_of_impact ?? hit?.toi;
});
