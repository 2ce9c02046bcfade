// Cases as glTF: node gltf.mjs CORPUS WORK. Runs the script on cases of every shape, has Khronos' validator
// look at what it writes, and checks shapes and motion. Prints a line a claim; exits with 1 if any does not hold.
import { validateBytes } from 'gltf-validator';
import { spawnSync } from 'node:child_process';
import { existsSync, mkdirSync, readFileSync, readdirSync, rmSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { bodyMesh, localBodies } from '../src/bodies.js';
import { netEdges } from '../src/patch_view.js';
import { grid, trimmed } from '../src/surface.js';

const [corpus, work] = process.argv.slice(2);
const script = join(dirname(fileURLToPath(import.meta.url)), '..', 'gltf.mjs');

let failures = 0;
function claim(what, holds, ...operands) {
  console.log(`${holds ? 'ok' : 'FAILED'}: ${what}${holds ? '' : ` (${operands.map((o) => JSON.stringify(o)).join(', ')})`}`);
  if (!holds) ++failures;
}

rmSync(work, { recursive: true, force: true });
mkdirSync(work, { recursive: true });
const run = (...args) => spawnSync(process.execPath, [script, ...args], { encoding: 'utf8' });
function written(known, name) {
  const path = join(work, `${name}.json`);
  writeFileSync(path, JSON.stringify(known));
  const { status, stderr } = run(path, '-o', join(work, `${name}.gltf`));
  if (status !== 0) throw new Error(`${name}: ${stderr}`);
  return JSON.parse(readFileSync(join(work, `${name}.gltf`), 'utf8'));
}

// Two counterexamples, some of engines, and without a contact every pair of shapes, one of them without an extent, with
// weights and without; of bodies each with the next.
const cases = readdirSync(corpus).filter((f) => f.endsWith('.json')).sort().slice(0, 2)
  .map((file) => JSON.parse(readFileSync(join(corpus, file), 'utf8')));
for (const engine of readdirSync(join(corpus, '..', 'engines'))) {
  const folder = join(corpus, '..', 'engines', engine);
  cases.push(...readdirSync(folder).filter((f) => f.endsWith('.json')).sort().slice(-2).map((file) => JSON.parse(readFileSync(join(folder, file), 'utf8'))));
}
const wave = (count, seed) => Array.from({ length: count }, (_, i) => [0, 1, 2].map((k) => Math.sin(seed + 5 * i + k)));
const shapes = [[{ shape: 'point' }, 1], [{ shape: 'curve', degree: 3 }, 4], [{ shape: 'triangle', degree: 2 }, 6],
  [{ shape: 'tensor', degree: [2, 1] }, 6]].map(([shape, count], s) => ({ ...shape, positions: wave(count, s), velocities: wave(count, s + 9) }));
const still = [[0, 0, 0], [0, 0, 0], [0, 0, 0]];
shapes.push({ shape: 'triangle', degree: 1, positions: still, velocities: still });
shapes.push({ shape: 'curve', degree: 3, positions: wave(4, 1), ends: wave(4, 5), weights: [1, 2, '0x1p-1', 3] });
shapes.push({ ...shapes[3], trim: [[[0, 0], [1, 0], ['0x1p-1', 1]], [[0.4, 0.25], [0.6, 0.25], [0.5, 0.5]]] });
const bodies = [[1, 0], [1, 1], [2, 0], [2, 0.5], [3, 0], [3, 0.25], [8, 0], [81, 0.125]]
  .map(([count, radius], s) => ({ shape: 'hull', positions: wave(count, s), velocities: wave(1, s + 5), radius }));
const pairs = [...shapes.flatMap((one) => shapes.map((two) => [one, two])), ...bodies.map((one, i) => [one, bodies[(i + 1) % bodies.length]])];
for (const [one, two] of pairs) {
  cases.push({ format: 'ccdfuzz-case', version: 1, t_max: '0x1p-1', patches: [one, two], truth: { collides: null } });
}
const complaints = [];
let number = 0;
for (const known of cases) {
  const name = `case-${++number}`;
  const gltf = written(known, name);
  const { issues } = await validateBytes(new Uint8Array(readFileSync(join(work, `${name}.gltf`))));
  complaints.push(...issues.messages.filter((m) => m.severity < 2).map((m) => `${name}: ${m.code} ${m.pointer}`));
  const moving = gltf.animations[0].channels.map((c) => c.target.node).sort((a, b) => a - b);
  const meshes = gltf.nodes.flatMap((node, at) => (node.mesh === undefined ? [] : [at]));
  if (JSON.stringify(moving) !== JSON.stringify(meshes)) complaints.push(`${name}: meshes that do not move`);
}
claim(`the validator has no complaint of ${number} cases`, complaints.length === 0, number, complaints.slice(0, 5));

/** A triangle that rises by `size` a second, and a point above its corner that rests; they touch at t = 1. */
const rising = (size) => ({
  format: 'ccdfuzz-case', version: 1, t_max: 2,
  patches: [
    { shape: 'triangle', degree: 1, positions: [[0, 0, 0], [0, size, 0], [size, 0, 0]], velocities: [[0, 0, size], [0, 0, size], [0, 0, size]] },
    { shape: 'point', positions: [[0, 0, size]], velocities: [[0, 0, 0]] },
  ],
  truth: { collides: true, witness: { t: '1', uv: [['0', '0'], ['0', '0']] } },
});
/** Bounds of the first mesh of that name at the begin, and of how much its points move. */
function bounds(gltf, name) {
  const [primitive] = gltf.meshes[gltf.nodes.find((n) => n.name === name).mesh].primitives;
  return [primitive.attributes, primitive.targets[0]].map(({ POSITION: at }) => [gltf.accessors[at].min, gltf.accessors[at].max]);
}
const same = (a, b) => JSON.stringify(a) === JSON.stringify(b);
{
  const gltf = written(rising(1), 'rising');
  // Seen from the contact, which moves along with the mean of both velocities.
  const [begin, motion] = bounds(gltf, 'patch 1');
  claim('a patch begins where it is relative to the contact', same(begin, [[0, 0, -0.5], [1, 1, -0.5]]), begin);
  claim('a patch moves as far as it does within the step', same(motion, [[0, 0, 1], [0, 0, 1]]), motion);
  const [triangle, point] = rising(1).patches;
  const byEnds = { ...rising(1), patches: [
    { ...triangle, velocities: undefined, ends: [[0, 0, 1], [0, 1, 1], [1, 0, 1]] }, { ...point, velocities: undefined, ends: point.positions }] };
  claim('positions at t = 1 in place of velocities give the same', same(written(byEnds, 'ends').buffers, gltf.buffers));
  claim('the other one comes from the other side', same(bounds(gltf, 'patch 2')[0], [[0, 0, 0.5], [0, 0, 0.5]]));
  claim('the contact has a node', gltf.nodes.some((n) => n.name === 'contact'));
  const { extras } = gltf.scenes[0];
  claim('extras say where, when and how large', same(extras, { origin: [0, 0, 1], unit: 1, t: 1, times: [-1, 1] }), extras);
}
for (const exponent of [-1060, -500, 500, 1020]) {
  const gltf = written(rising(2 ** exponent), `size${exponent}`);
  const [begin] = bounds(gltf, 'patch 1');
  claim(`2^${exponent} is brought into single precision by a power of two`,
    gltf.scenes[0].extras.unit === 2 ** exponent && same(begin, [[0, 0, -0.5], [1, 1, -0.5]]), gltf.scenes[0].extras, begin);
}

// What is no case ends with 2, says what and where, and leaves no file.
const bad = { ...rising(1) };
for (const [change, said] of [
  [{ format: 'x' }, 'format is not "ccdfuzz-case"'],
  [{ t_max: -1 }, 't_max is not a positive number'],
  [{ patches: [] }, 'patches: there are not two'],
  [{ patches: [{ ...bad.patches[0], shape: 'sphere' }, bad.patches[1]] }, 'patches[0].shape is none of'],
  [{ patches: [{ ...bad.patches[0], degree: 1e9 }, bad.patches[1]] }, 'patches[0].degree is not from 0 to 8'],
  [{ patches: [{ ...bad.patches[0], degree: 2 }, bad.patches[1]] }, 'patches[0].positions does not have as many rows'],
  [{ patches: [{ ...bad.patches[0], weights: [1, 0, 1] }, bad.patches[1]] }, 'patches[0].weights is not a positive number'],
  [{ patches: [{ ...bad.patches[0], trim: [[[0, 0], [1, 0]]] }, bad.patches[1]] }, 'patches[0].trim has a loop'],
  [{ patches: [bodies[0], bad.patches[1]] }, 'one is a body and one is not'],
  [{ patches: [bodies[0], { ...bodies[1], radius: -1 }] }, 'patches[1].radius is not'],
  [{ patches: [bodies[0], { ...bodies[1], positions: [] }] }, 'patches[1].positions does not have 1 to 81 rows'],
  [{ patches: [bad.patches[0], { ...bad.patches[1], velocities: [[0, 'x', 0]] }] }, 'patches[1].velocities has a row'],
  [{ truth: { witness: { t: 'x', uv: [['0', '0'], ['0', '0']] } } }, 'BigInt'],
]) {
  const path = join(work, 'bad.json');
  writeFileSync(path, JSON.stringify({ ...bad, ...change }));
  const { status, stderr } = run(path, '-o', join(work, 'bad.gltf'));
  claim(`refused: ${said}`, status === 2 && stderr.startsWith(`gltf.mjs: ${path}: `) && stderr.includes(said) && !existsSync(join(work, 'bad.gltf')), status, stderr);
}
claim('refused: no case named', run('-o', join(work, 'bad.gltf')).status === 2);
claim('refused: no such file', run(join(work, 'nothing.json'), '-o', join(work, 'bad.gltf')).status === 2);

// A spin is drawn in doubles.
{
  const spin = { velocity: [0, 0, Math.PI], centre: [1, 0, 0] };
  const hulls = [[5, 0, 0], [1, 4, 0]].map((place, s) => ({ shape: 'hull', positions: [place], velocities: [[0, 0, 0]], ...(s === 0 ? { spin } : {}) }));
  const { origin } = localBodies({ patches: hulls, truth: { witness: { t: '1/2', weights: [['1'], ['1']] } } }, { uv: [], t: [1n, 2n], witness: true });
  claim('a body that spins is drawn where it touches', origin.every((x, k) => Math.abs(x - [1, 4, 0][k]) < 1e-14), origin);
}
// The far end of a segment, which turns about the near one, meets a point at t = 1.
for (const [what, turn, place] of [
  ['a quaternion', { from: [1, 0, 0, 0], to: [1, 0, 0, 1] }, [0, 5, 0]],
  ['a quaternion about a centre', { from: [1, 0, 0, 0], to: [1, 0, 0, 1], centre: [1, 0, 0] }, [1, 4, 0]],
  ['a cosine and a sine', { from: [5, 0], to: [3, 4] }, [3, 4, 0]],
]) {
  const still = [[0, 0, 0]];
  const hulls = [{ shape: 'hull', positions: [[0, 0, 0], [5, 0, 0]], velocities: still, turn }, { shape: 'hull', positions: [place], velocities: still }];
  const known = { patches: hulls, truth: { witness: { t: '1', weights: [['0', '1'], ['1']] } } };
  const { apart, origin } = localBodies(known, { uv: [], t: [1n, 1n], witness: true });
  claim(`a body that turns by ${what} is drawn where it touches`, !apart && origin.every((x, k) => x === place[k]), apart, origin);
}

// Surfaces and nets of both the page and the files.
for (const [kind, area] of [['triangle', 0.5], ['tensor', 1]]) {
  const { at, faces } = grid({ kind });
  let sum = 0;
  let least = Infinity;
  for (let i = 0; i < faces.length; i += 3) {
    const [p, q, r] = faces.slice(i, i + 3).map((v) => at[v]);
    const twice = (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);
    least = Math.min(least, twice);
    sum += twice / 2;
  }
  claim(`the triangles of a ${kind} cover its domain once`, least > 0 && Math.abs(sum - area) < 1e-12, least, sum);
}
// A trim leaves the even-odd region of its loops, up to the step on its border.
const loop = (...points) => points.map((p, i) => [p, points[(i + 1) % points.length]]);
const square = (low, high) => loop([low, low], [high, low], [high, high], [low, high]);
for (const [what, segments, area] of [
  ['square', square(0.25, 0.75), 0.25], ['square with a hole', [...square(0.125, 0.875), ...square(0.25, 0.75)], 0.3125],
  ['island in a hole', [...square(0, 1), ...square(0.25, 0.75), ...square(0.375, 0.625)], 0.8125],
  ['triangle', loop([0.1, 0.1], [0.9, 0.2], [0.3, 0.8]), 0.27], ['two squares that touch along an edge', [...square(0, 0.5), ...loop([0.5, 0], [1, 0], [1, 0.5], [0.5, 0.5])], 0.5],
  ['all', square(0, 1), 1],
]) {
  const { at, faces } = trimmed(grid({ kind: 'tensor' }), segments);
  let sum = 0;
  for (let i = 0; i < faces.length; i += 3) {
    const [p, q, r] = faces.slice(i, i + 3).map((v) => at[v]);
    sum += ((q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])) / 2;
  }
  claim(`what a trim leaves has its area: ${what}`, Math.abs(sum - area) < 0.005, sum, area);
}
for (const [shape, lines] of [
  [{ kind: 'triangle', n: 1, m: 0 }, 3], [{ kind: 'triangle', n: 2, m: 0 }, 9], [{ kind: 'tensor', n: 2, m: 1 }, 7],
  [{ kind: 'curve', n: 3, m: 0 }, 3], [{ kind: 'point', n: 0, m: 0 }, 0],
]) {
  claim(`a net has its lines: ${shape.kind} ${shape.n}, ${shape.m}`, netEdges(shape).length === 2 * lines, netEdges(shape));
}

// Bodies: closed surfaces, of the volume that they have, within a hundredth.
function volumeOf({ at, faces }) {
  let sum = 0;
  for (let i = 0; i < faces.length; i += 3) {
    const [p, q, r] = faces.slice(i, i + 3).map((v) => at[v]);
    sum += (p[0] * (q[1] * r[2] - q[2] * r[1]) + p[1] * (q[2] * r[0] - q[0] * r[2]) + p[2] * (q[0] * r[1] - q[1] * r[0])) / 6;
  }
  return sum;
}
function isClosed({ faces }) {
  const sides = new Set();
  for (let i = 0; i < faces.length; i += 3) for (let k = 0; k < 3; ++k) sides.add(`${faces[i + k]},${faces[i + ((k + 1) % 3)]}`);
  return sides.size === faces.length && [...sides].every((side) => sides.has(side.split(',').reverse().join()));
}
const box = [0, 1, 2, 3, 4, 5, 6, 7].map((i) => [i & 1, i & 2, 0.75 * (i & 4)]);  // 1 by 2 by 3
const ball = (4 / 3) * Math.PI;
for (const [what, points, radius, volume] of [
  ['ball', [[1, 2, 3]], 2, 8 * ball],
  ['capsule', [[0, 0, 0], [0, 5, 0]], 1, ball + 5 * Math.PI],
  ['rounded triangle', [[0, 0, 0], [4, 0, 0], [0, 3, 0]], 0.5, 6 + (12 * Math.PI) / 8 + ball / 8],
  ['box', box, 0, 6],
  ['box far away', box.map((p) => p.map((x) => x + 2 ** 30)), 0, 6],
  ['rounded box', box, 0.25, 6 + 22 / 4 + (24 * Math.PI) / 64 + ball / 64],
  ['rounded square of 81 points', Array.from({ length: 81 }, (_, i) => [i % 9, Math.floor(i / 9), 0]), 0.5, 64 + (32 * Math.PI) / 8 + ball / 8],
]) {
  const mesh = bodyMesh(points, radius, [0, 0, 1]);
  const moved = { ...mesh, at: mesh.at.map((p) => p.map((x, k) => x - mesh.at[0][k])) };
  claim(`a ${what} is a closed surface`, isClosed(mesh), mesh.faces.length);
  claim(`a ${what} has its volume`, Math.abs(volumeOf(moved) / volume - 1) < 0.01, volumeOf(moved), volume);
}
for (const [what, points, radius, count, triangles] of [
  ['point', [[1, 1, 1], [1, 1, 1]], 0, 1, 0], ['segment', [[0, 0, 0], [1, 1, 1], [2, 2, 2]], 0, 2, 0],
  ['triangle', [[0, 0, 0], [4, 0, 0], [0, 3, 0]], 0, 3, 1], ['segment with a radius of nothing', [[0, 0, 0], [1, 0, 0]], 2 ** -40, 2, 0],
]) {
  const { at, faces } = bodyMesh(points, radius, null);
  claim(`a ${what} is drawn as one`, at.length === count && faces.length === 3 * triangles, at, faces);
}

console.log(failures === 0 ? 'all as claimed' : `${failures} claims do not hold`);
process.exit(failures === 0 ? 0 : 1);
