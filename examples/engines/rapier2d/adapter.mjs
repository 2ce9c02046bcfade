// Rapier in 2-D (npm @dimforge/rapier2d-compat): the time of impact of two shapes, by castShape.
import RAPIER from '@dimforge/rapier2d-compat';

import { Refusal, ball, promiseOf, serve } from '../bodies.mjs';

const quiet = console.warn;
console.warn = () => {};
await RAPIER.init();
console.warn = quiet;

const vector = ([x, y]) => ({ x, y });

function shape({ points, radius, half }) {
  const corners = points.map(vector);
  if (points.length === 1) {
    if (!(radius > 0)) throw new Refusal('has no shape of one point without a radius');
    return new RAPIER.Ball(radius);
  }
  if (points.length === 2 && radius === 0) return new RAPIER.Segment(...corners);
  if (points.length === 3) {
    return radius === 0 ? new RAPIER.Triangle(...corners) : new RAPIER.RoundTriangle(...corners, radius);
  }
  const [x, y] = half ?? [];
  if (half) return radius === 0 ? new RAPIER.Cuboid(x, y) : new RAPIER.RoundCuboid(x, y, radius);
  if (points.length < 4) throw new Refusal('has no capsule along any axis but y');
  const all = new Float32Array(points.flatMap(([p, q]) => [p, q]));
  const polygon = radius === 0 ? new RAPIER.ConvexPolygon(all, false)
                               : new RAPIER.RoundConvexPolygon(all, radius, false);
  const raw = polygon.intoRaw();
  if (!raw) throw new Refusal('makes no polygon of these corners');
  raw.free();
  return polygon;
}

// The target distance, 0, came with version 0.13.
const distance = RAPIER.Shape.prototype.castShape.length < 10 ? [] : [0];
const still = vector([0, 0]);
const promise = promiseOf(import.meta.url);
const overlap = promiseOf(import.meta.url, 'overlap.json');
const bodies = [ball, { least_points: 2, most_points: 2, radius: 'zero' },
                { least_points: 3, most_points: 12 }];
const hello = { name: 'Rapier 2-D', version: RAPIER.version(), promise, overlap, tolerance: 1e-4, bodies,
                plane: true };
await serve(hello, (a, b, way) => {
  const hit = shape(a).castShape(vector(a.centre), 0, vector(way), shape(b), vector(b.centre), 0,
                                 still, ...distance, 1, true);
  return hit?.time_of_impact ?? hit?.toi;
});
