// planck (npm planck, Box2D in JavaScript): the time of impact of two shapes, by TimeOfImpact. Its
// shapes have a skin: polygons and edges are the core, as its documentation says. With the option
// spins=1 some spin: a Sweep interpolates its angle linearly.
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { Circle, Edge, Polygon, Settings, Sweep, TOIInput, TOIOutput, TOIOutputState, TimeOfImpact }
  from 'planck';

import { GaveUp, Refusal, ball, promiseOf, serve } from '../bodies.mjs';

const manifest = new URL('../package.json', `file://${createRequire(import.meta.url).resolve('planck')}`);
const { version } = JSON.parse(readFileSync(manifest));
const vector = ([x, y]) => ({ x, y });
const slop = Settings.linearSlop;

/// A polygon welds corners that are nearer to each other than half of the slop.
function shape({ points, radius }) {
  const corners = points.map(vector);
  if (points.length === 1) return new Circle(vector(points[0]), radius);
  if (points.length === 2) return new Edge(...corners);
  const isWelded = corners.some((p, i) => corners.slice(0, i).some(
    (q) => Math.hypot(p.x - q.x, p.y - q.y) <= slop / 2));
  if (isWelded) throw new Refusal('welds corners that are so near');
  return new Polygon(corners);
}

function sweep({ centre, velocity, spin }, tMax) {
  const pivot = spin?.centre ?? centre;
  const motion = new Sweep();
  motion.localCenter = vector(pivot.map((x, k) => x - centre[k]));
  motion.c0 = vector(pivot);
  motion.c = vector(pivot.map((x, k) => x + tMax * velocity[k]));
  motion.a = tMax * (spin?.velocity[2] ?? 0);
  return motion;
}

function cast(a, b, _, tMax) {
  const input = new TOIInput();
  input.proxyA.set(shape(a), 0);
  input.proxyB.set(shape(b), 0);
  input.sweepA = sweep(a, tMax);
  input.sweepB = sweep(b, tMax);
  input.tMax = 1;
  const output = new TOIOutput();
  TimeOfImpact(output, input);
  const { e_failed: failed, e_separated: separated } = TOIOutputState;
  if (output.state === failed) throw new GaveUp('e_failed');
  return output.state === separated ? undefined : output.t;
}

// Two circles stop where they overlap by three slops, and a quarter of one is its tolerance.
const promise = promiseOf(import.meta.url);
const spins = 'none of bodies that spin: its documentation says that it may miss collisions';
const polygon = { least_points: 2, most_points: Settings.maxPolygonVertices, radius: 'zero' };
await serve({ name: 'planck', version, promise, spins, tolerance: 3.25 * slop, bodies: [ball, polygon],
              plane: true, numbers: 'binary64', far: 40 }, cast);
