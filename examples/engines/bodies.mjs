// What the adapters of physics engines share: the loop of a plug-in by lines of JSON, and bodies.
// A body is the hull of `points` about `centre`, with a ball of `radius` around each of its points; or
// its `mesh` has `faces`, the triples of places of their corners, and may be `oneSided`.
import { readFileSync } from 'node:fs';
import { createInterface } from 'node:readline';

/// Thrown where an engine promises nothing of a query.
export class Refusal extends Error {}
/// Thrown where an engine says that it has failed.
export class GaveUp extends Error {}

export function float32(x, what) {
  if (Math.fround(x) !== x) throw new Refusal(`${what} is no float`);
  return x;
}

const hull = { shape: 'hull' };
/// Kinds of bodies. Overlaps are measured for hulls of up to 12 points each.
export const ball = { least_points: 1, most_points: 1, radius: 'positive' };
export const solid = { least_points: 4, most_points: 12, radius: 'zero' };
export const stick = { least_points: 2, most_points: 2, radius: 'positive' };

const axes = [0, 1, 2];
const low = (points, k) => Math.min(...points.map((p) => p[k]));
const high = (points, k) => Math.max(...points.map((p) => p[k]));
const differences = (points, from) => points.map((p) => axes.map((k) => p[k] - from[k]));
const allFloats = (points) => points.every((p) => p.every((x) => Math.fround(x) === x));

/// The points as the engine gets them: about the middle where these differences are floats, and
/// else as they are.
function body(patch, { plane, numbers, most }) {
  const { positions, radius = 0, velocities, faces, sides, spin } = patch;
  const middle = axes.map((k) => (low(positions, k) + high(positions, k)) / 2);
  const about = differences(positions, middle);
  const isExact = (p, q) => axes.every((k) => p[k] + middle[k] === q[k] && q[k] - p[k] === middle[k]);
  const areGiven = numbers === 'binary64' && most < Infinity || allFloats([middle, ...about]);
  const exact = areGiven && about.every((p, i) => isExact(p, positions[i]));
  const centre = exact ? middle : [0, 0, 0];
  const points = exact ? about : positions;
  if (numbers === 'binary32') points.concat([[radius]]).flat().forEach((x) => float32(x, 'a number'));
  if (points.flat().some((x) => Math.abs(x) > most)) throw new Refusal('a body far off is wide, or has no middle');
  const half = exact ? halfExtents(points, plane ? 2 : 3) : undefined;
  const mesh = faces && { faces, oneSided: sides === 1 };
  return { centre, points, radius, half: mesh ? undefined : half, velocity: velocities[0], spin, mesh };
}

/// Of a box, or rectangle, about 0 whose edges are along the axes; undefined of others.
function halfExtents(points, dimensions) {
  const half = axes.map((k) => high(points, k));
  const corners = new Set(points.map((p) => p.map((x, k) => x === half[k]).join()));
  const isBox = points.every((p) => p.every((x, k) => Math.abs(x) === half[k])) &&
    half.every((x, k) => x > 0 || k >= dimensions);
  return isBox && [points.length, corners.size].every((n) => n === 2 ** dimensions) ? half : undefined;
}

/// Of a capsule: half its length without the ends, and the turn (x, y, z, w) from an axis into its
/// direction. As floats they are off by less than 2^-22 of the length: half of a tolerance of 1e-4.
export function capsule({ points: [p, q] }, axis) {
  if (axes.some((k) => p[k] !== -q[k])) throw new Refusal('the middle of a capsule is no float');
  const half = Math.hypot(...q);
  const to = q.map((x) => (q[axis] < 0 ? -x : x) / half);  // none of its ends is the first
  const [next, last] = [(axis + 1) % 3, (axis + 2) % 3];
  const turn = [0, 0, 0, 1 + to[axis]];
  [turn[next], turn[last]] = [-to[last], to[next]];
  return { half, turn: turn.map((x) => x / Math.hypot(...turn)) };
}

/// What the engine of an adapter says that it does, with a link: promise.json beside it. What it
/// says of starts in contact is in overlap.json.
export const promiseOf = (adapter, file = 'promise.json') => JSON.parse(readFileSync(new URL(file, adapter)));

/// Positions and ways of up to 2^far end within twice that. There a number of so many bits is rounded
/// by 2^(far - bits) at most along an axis, and an engine rounds two positions and a way.
const rounding = (far, bits) => 3 * Math.sqrt(3) * 2 ** (far - bits);

/// Answers queries until the input ends. cast(a, b, way, tMax) gives the share of `way`, the motion of a
/// against b in the whole step, after which the two bodies touch; undefined: they do not. `promise`
/// is what the engine is held to (promiseOf). It promises nothing of contacts at an
/// end of the step, of bodies that touch at the start or have no volume, of numbers that are no
/// floats or outside of 1/128 to 128, nor of overlaps less deep than `tolerance`. `bodies` are
/// those that it has shapes for; `plane`: they are in the plane z = 0. It may have doubles for
/// numbers (`binary64`). With the option `any-numbers=1` a query may have any that can be given to it
/// exactly, and be degenerate. With `spins=1` it is asked about bodies with a `spin`, too, if `spins` says what it
/// promises of them. With `mesh=1` it is asked about meshes, too, if it has them: of so many `sides`. The mesh is
/// the second then. A `meshTolerance` is for what the engine rounds of meshes. With `overlap=1` it is
/// asked about bodies that touch or overlap at the start, too, if `overlap` says what it promises of
/// them: a hit at 0. With `far=1` positions are
/// up to 2^far, if its promise goes so far, of bodies that are within 128 about their middle; what is
/// rounded there is allowed. It refuses other options.
export async function serve(adapter, cast) {
  const { name, version, promise, tolerance, bodies, plane = false, numbers = 'binary32', sides = [] } = adapter;
  const { spins = '', overlap = '', meshTolerance = tolerance, far = 0 } = adapter;
  let most = Infinity;  // of a coordinate about a body's middle; options come with the first line alone
  for await (const line of createInterface({ input: process.stdin })) {
    const asked = JSON.parse(line);
    const options = (asked.options ?? '').split(':').filter((option) => option !== '');
    const known = ['any-numbers=1', ...(spins ? ['spins=1'] : []), ...(sides.length > 0 ? ['mesh=1'] : []),
                   ...(overlap ? ['overlap=1'] : []), ...(far ? ['far=1'] : [])];
    const unknown = options.find((option) => !known.includes(option));
    const [any, turning, meshes, overlaps, isFar] =
      ['any-numbers=1', 'spins=1', 'mesh=1', 'overlap=1', 'far=1'].map((option) => options.includes(option));
    if (isFar) most = 128;
    const reply = unknown !== undefined
      ? { refused: 'options', message: `unknown option ${unknown}; there are: ${known.join(' ')}` }
      : asked.ask === 'describe'
      ? { protocol: 1, name, version, promise: (turning ? spins : promise) + (overlaps ? `; ${overlap}` : ''), accepts: [[hull, hull]],
          takes_bodies: true, takes_spins: turning,
          takes_meshes: meshes && sides.includes(2), takes_one_sided: meshes && sides.includes(1),
          bodies, plane, numbers: any ? 'binary64' : numbers, within: any ? 0 : isFar ? far : 7, ordinary: !any,
          initial_overlap: overlaps, closed_t_max: false, contact_at_zero: overlaps, tolerance_kind: 'space',
          tolerance: (meshes ? meshTolerance : tolerance) + (isFar ? rounding(far, numbers === 'binary32' ? 24 : 53) : 0) }
      : { id: asked.id, ...answer(asked, { plane, numbers, most }, cast) };
    process.stdout.write(JSON.stringify(reply) + '\n');
  }
}

function answer({ patches, t_max: tMax }, domain, cast) {
  const float = domain.numbers === 'binary32' ? float32 : (x) => x;
  try {
    const bodies = patches.map((patch) => body(patch, domain));
    const [a, b] = bodies[0].mesh ? bodies.reverse() : bodies;
    const way = axes.map((k) => float((a.velocity[k] - b.velocity[k]) * tMax, 'the relative motion'));
    const start = performance.now();
    const share = cast(a, b, way, tMax);
    const seconds = (performance.now() - start) / 1000;
    return share === undefined ? { verdict: 'miss', seconds } : { verdict: 'hit', toi: share * tMax, seconds };
  } catch (error) {
    if (error instanceof Refusal) return { verdict: 'refused', message: error.message };
    if (error instanceof GaveUp) return { verdict: 'inconclusive', message: error.message };
    throw error;
  }
}
