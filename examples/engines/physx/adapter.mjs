// PhysX 5 (npm physx-js-webidl): the distance of a sweep, by PxGeometryQuery.sweep. It takes a
// distance and a unit vector, in floats: both and their product are rounded, by 2^-24 each. Ways of up
// to 128 along each axis are no longer than 222: rounded by 4e-5 at most, less than half the tolerance.
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';

import { Refusal, ball, capsule, promiseOf, serve, solid, stick } from '../bodies.mjs';
import { triangles } from './mesh.mjs';

const require = createRequire(import.meta.url);
const folder = require.resolve('physx-js-webidl/package.json');
const { version } = JSON.parse(readFileSync(folder));
const { process: node } = globalThis;
// The package is for browsers and refuses to run where it sees Node.
delete globalThis.process;
globalThis.window = {};
const { default: initPhysX } = await import('physx-js-webidl');
const wasmBinary = readFileSync(new URL('physx-js-webidl.wasm', `file://${folder}`));
const physx = await initPhysX({ wasmBinary, print: () => {}, printErr: () => {} });
globalThis.process = node;

const top = physx.PxTopLevelFunctions.prototype;
const foundation = top.CreateFoundation(physx.PHYSICS_VERSION, new physx.PxDefaultAllocator(),
                                        new physx.PxDefaultErrorCallback());
const cooking = new physx.PxCookingParams(new physx.PxTolerancesScale());
cooking.planeTolerance = 0;  // by default faces that are nearly in one plane become one
if (!foundation) throw new Error('PhysX has no foundation');

let made = [];
const keep = (object) => (made.push(object), object);
const vector = ([x, y, z]) => keep(new physx.PxVec3(x, y, z));
const isCapsule = ({ points, radius }) => points.length === 2 && radius > 0;
const turn = (body) => keep(new physx.PxQuat(...(isCapsule(body) ? capsule(body, 0).turn : [0, 0, 0, 1])));

function shape(body) {
  const { points, radius, half, mesh: isMesh } = body;
  if (isMesh) return triangles(physx, top, cooking, body, vector, keep);
  if (points.length === 1 && radius > 0) return keep(new physx.PxSphereGeometry(radius));
  if (isCapsule(body)) return keep(new physx.PxCapsuleGeometry(radius, capsule(body, 0).half));
  if (half && radius === 0) return keep(new physx.PxBoxGeometry(...half));
  if (points.length < 4 || radius > 0) throw new Refusal('has no such shape');
  const corners = keep(new physx.PxArray_PxVec3(0));
  for (const p of points) corners.pushBack(vector(p));
  const description = keep(new physx.PxConvexMeshDesc());
  description.flags = keep(new physx.PxConvexFlags(physx._emscripten_enum_PxConvexFlagEnum_eCOMPUTE_CONVEX()));
  description.points.count = points.length;
  description.points.stride = 12;
  description.points.data = corners.begin();
  const mesh = top.CreateConvexMesh(cooking, description);
  if (!mesh) throw new Refusal('does not make a convex mesh of these corners');
  return keep(new physx.PxConvexMeshGeometry(mesh));
}

function sweep(a, b, way) {
  const length = Math.fround(Math.hypot(...way));
  if (!(length > 0 && length <= 222)) throw new Refusal('is asked about ways of at most 222');
  const [poseA, poseB] = [a, b].map((body) => keep(new physx.PxTransform(vector(body.centre), turn(body))));
  const hit = keep(new physx.PxSweepHit());
  const sides = b.mesh && !b.mesh.oneSided ? physx._emscripten_enum_PxHitFlagEnum_eMESH_BOTH_SIDES() : 0;
  const flags = keep(new physx.PxHitFlags(physx._emscripten_enum_PxHitFlagEnum_eDEFAULT() | sides));
  const touches = physx.PxGeometryQuery.prototype.sweep(
    vector(way.map((x) => x / length)), length, shape(a), poseA, shape(b), poseB, hit, flags);
  return touches ? hit.distance / length : undefined;
}

// It states no tolerance: an overlap less deep than this is not held against it.
const promise = promiseOf(import.meta.url);
const overlap = promiseOf(import.meta.url, 'overlap.json');
const hello = { name: 'PhysX', version, promise, overlap, tolerance: 1e-4,
                bodies: [ball, stick, solid], sides: [1, 2] };
await serve(hello, (...query) => {
  try {
    return sweep(...query);
  } finally {
    for (const object of made.reverse()) physx.destroy(object);
    made = [];
  }
});
