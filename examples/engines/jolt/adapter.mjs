// Jolt Physics (npm jolt-physics): the fraction of a shape cast, by TransformedShape.CastShape.
// Convex radii are 0 where the query has no radius. Back faces count, as in a query about bodies.
import { createRequire } from 'node:module';
import initJolt from 'jolt-physics/wasm-compat';

import { Refusal, ball, capsule, promiseOf, serve, solid, stick } from '../bodies.mjs';
import { meshRounding, registerShapes, triangles } from './shapes.mjs';

const { version } = createRequire(import.meta.url)('jolt-physics/package.json');
const Jolt = await initJolt();
registerShapes(Jolt);

/// Frees what the steps of a query have made, when it is over.
let made = [];
const keep = (object) => (made.push(object), object);
const vector = ([x, y, z]) => keep(new Jolt.Vec3(x, y, z));
const place = ([x, y, z]) => keep(new Jolt.RVec3(x, y, z));

const isCapsule = ({ points, radius }) => points.length === 2 && radius > 0;
const turn = (body) => keep(new Jolt.Quat(...(isCapsule(body) ? capsule(body, 1).turn : [0, 0, 0, 1])));

function shape(body) {
  const { points, radius, half, mesh } = body;
  if (mesh) return triangles(Jolt, body, vector, keep);
  if (points.length === 1) {
    if (!(radius > 0)) throw new Refusal('has no sphere without a radius');
    return new Jolt.SphereShape(radius);
  }
  if (isCapsule(body)) return new Jolt.CapsuleShape(capsule(body, 1).half, radius);
  if (half && radius === 0) return new Jolt.BoxShape(vector(half), 0);
  if (points.length < 4 || radius > 0) throw new Refusal('has no such rounded shape of free corners');
  const settings = keep(new Jolt.ConvexHullShapeSettings());
  settings.mMaxConvexRadius = 0;
  settings.mHullTolerance = 0;  // by default a hull may leave out points within a thousandth
  for (const p of points) settings.mPoints.push_back(vector(p));
  const result = settings.Create();
  if (result.HasError()) throw new Refusal(result.GetError().c_str());
  return result.Get();
}

function cast(a, b, way) {
  const [first, second] = [a, b].map(shape);
  // Hulls are about their own centre of mass; GetCenterOfMass is where it lies among the points.
  const middle = (body, of) => {
    const c = of.GetCenterOfMass();
    return place([body.centre[0] + c.GetX(), body.centre[1] + c.GetY(), body.centre[2] + c.GetZ()]);
  };
  const target = keep(new Jolt.TransformedShape());
  target.mShape = second;
  target.mShapePositionCOM = middle(b, second);
  target.mShapeRotation = turn(b);
  const start = Jolt.RMat44.prototype.sRotationTranslation(turn(a), middle(a, first));
  const one = vector([1, 1, 1]);
  const settings = keep(new Jolt.ShapeCastSettings());
  settings.mBackFaceModeTriangles = settings.mBackFaceModeConvex = Jolt.EBackFaceMode_CollideWithBackFaces;
  if (b.mesh?.oneSided) settings.mBackFaceModeTriangles = Jolt.EBackFaceMode_IgnoreBackFaces;
  const collector = keep(new Jolt.CastShapeClosestHitCollisionCollector());
  target.CastShape(keep(new Jolt.RShapeCast(first, one, start, vector(way))), settings,
                   place([0, 0, 0]), collector, keep(new Jolt.ShapeFilter()));
  return collector.HadHit() ? collector.mHit.mFraction : undefined;
}

const promise = promiseOf(import.meta.url);
const overlap = promiseOf(import.meta.url, 'overlap.json');
const tolerance = keep(new Jolt.ShapeCastSettings()).mCollisionTolerance;
const hello = { name: 'Jolt Physics', version, promise, overlap, tolerance, bodies: [ball, stick, solid],
                sides: [1, 2], meshTolerance: tolerance + meshRounding, far: 12 };
await serve(hello, (...query) => {
  try {
    return cast(...query);
  } finally {
    for (const object of made.reverse()) Jolt.destroy(object);
    made = [];
  }
});
