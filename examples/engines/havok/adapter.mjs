// Havok Physics (npm @babylonjs/havok): the fraction of a shape cast into a world of one body.
import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import HavokPhysics from '@babylonjs/havok';

import { Refusal, ball, promiseOf, serve, solid } from '../bodies.mjs';

const wasm = fileURLToPath(import.meta.resolve('@babylonjs/havok/lib/esm/HavokPhysics.wasm'));
const manifest = new URL('../../package.json', `file://${wasm}`);
const { version } = JSON.parse(readFileSync(manifest));
const hk = await HavokPhysics({ wasmBinary: readFileSync(wasm) });

const origin = [0, 0, 0];
const noTurn = [0, 0, 0, 1];
const everything = [~0, ~0];

function need([result, value]) {
  if (result !== hk.Result.RESULT_OK) throw new Error(`a call of Havok fails: ${result.value}`);
  return value;
}

/// `offset` is its middle in the coordinates of the body.
function shape({ points: about, radius, half }, offset) {
  const points = about.map((p) => p.map((x, k) => x + offset[k]));
  if (points.length === 1 && radius > 0) return need(hk.HP_Shape_CreateSphere(points[0], radius));
  if (points.length === 2 && radius > 0) return need(hk.HP_Shape_CreateCapsule(...points, radius));
  if (half && radius === 0) return need(hk.HP_Shape_CreateBox(offset, noTurn, half.map((x) => 2 * x)));
  if (points.length < 4 || radius > 0) throw new Refusal('has no such shape');
  const address = hk._malloc(points.length * 12);
  new Float32Array(hk.HEAPU8.buffer, address, points.length * 3).set(points.flat());
  try {
    return need(hk.HP_Shape_CreateConvexHull(address, points.length));
  } finally {
    hk._free(address);
  }
}

const world = need(hk.HP_World_Create());
const collector = need(hk.HP_QueryCollector_Create(1));

function cast(a, b, way) {
  const after = a.centre.map((x, k) => x + way[k]);
  // It takes an end position. Where that is no float, the body starts at 0 with its shape off that.
  const [start, end, offset] = after.every((x, k) => Math.fround(x) === x && x - way[k] === a.centre[k])
    ? [a.centre, after, origin] : [origin, way, a.centre];
  const [first, second] = [shape(a, offset), shape(b, origin)];
  const body = need(hk.HP_Body_Create());
  for (const [id] of [[first], [second]]) hk.HP_Shape_SetFilterInfo(id, everything);
  hk.HP_Body_SetShape(body, second);
  hk.HP_Body_SetMotionType(body, hk.MotionType.STATIC);
  hk.HP_Body_SetPosition(body, b.centre);
  hk.HP_World_AddBody(world, body, false);
  try {
    hk.HP_World_ShapeCastWithCollector(world, collector, [first, noTurn, start, end, false, [0n]]);
    if (need(hk.HP_QueryCollector_GetNumHits(collector)) === 0) return undefined;
    return need(hk.HP_QueryCollector_GetShapeCastResult(collector, 0))[0];
  } finally {
    hk.HP_World_RemoveBody(world, body);
    hk.HP_Body_Release(body);
    for (const id of [first, second]) hk.HP_Shape_Release(id);
  }
}

// It states no tolerance: an overlap less deep than this is not held against it.
const promise = promiseOf(import.meta.url);
const capsule = { least_points: 2, most_points: 2, radius: 'positive' };
await serve({ name: 'Havok', version, promise, tolerance: 1e-4, bodies: [ball, capsule, solid] }, cast);
