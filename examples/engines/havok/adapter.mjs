// Havok Physics (npm @babylonjs/havok): the fraction of a shape cast into a world of one body.
import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import HavokPhysics from '@babylonjs/havok';

import { Refusal, ball, promiseOf, serve, solid } from '../bodies.mjs';

const wasm = fileURLToPath(import.meta.resolve('@babylonjs/havok/lib/esm/HavokPhysics.wasm'));
const manifest = new URL('../../package.json', `file://${wasm}`);
const { version } = JSON.parse(readFileSync(manifest));
const hk = await HavokPhysics({ wasmBinary: readFileSync(wasm) });

const noTurn = [0, 0, 0, 1];
const everything = [~0, ~0];

function need([result, value]) {
  if (result !== hk.Result.RESULT_OK) throw new Error(`a call of Havok fails: ${result.value}`);
  return value;
}

function shape({ points, radius, half }) {
  if (points.length === 1 && radius > 0) return need(hk.HP_Shape_CreateSphere([0, 0, 0], radius));
  if (points.length === 2 && radius > 0) return need(hk.HP_Shape_CreateCapsule(...points, radius));
  if (half && radius === 0) {
    return need(hk.HP_Shape_CreateBox([0, 0, 0], noTurn, half.map((x) => 2 * x)));
  }
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
  const end = a.centre.map((x, k) => {
    const y = x + way[k];
    if (Math.fround(y) !== y) throw new Refusal('takes an end position, and here it is no float');
    return y;
  });
  const [first, second] = [a, b].map(shape);
  const body = need(hk.HP_Body_Create());
  for (const [id] of [[first], [second]]) hk.HP_Shape_SetFilterInfo(id, everything);
  hk.HP_Body_SetShape(body, second);
  hk.HP_Body_SetMotionType(body, hk.MotionType.STATIC);
  hk.HP_Body_SetPosition(body, b.centre);
  hk.HP_World_AddBody(world, body, false);
  try {
    hk.HP_World_ShapeCastWithCollector(world, collector, [first, noTurn, a.centre, end, false, [0n]]);
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
