// The surface of a part of a patch or of a body, as triangles or lines, for all that draws or cuts it.
import { evaluate } from './local.js';

const kSteps = 28;
const kTrimHalvings = 4;  // of a triangle on the border of a trim: a step of 1/448 of the domain

/** Parameters (x, y) of a grid over the domain, and its triangles. */
export function grid({ kind }) {
  const at = [];
  const faces = [];
  if (kind === 'point') return { at: [[0, 0]], faces };
  if (kind === 'curve') {
    for (let i = 0; i <= 2 * kSteps; ++i) at.push([i / (2 * kSteps), 0]);
    return { at, faces };
  }
  const rows = [];
  for (let i = 0; i <= kSteps; ++i) {
    rows.push(at.length);
    const last = kind === 'triangle' ? kSteps - i : kSteps;
    for (let j = 0; j <= last; ++j) at.push([i / kSteps, j / kSteps]);
  }
  for (let i = 0; i < kSteps; ++i) {
    const last = kind === 'triangle' ? kSteps - i : kSteps;
    for (let j = 0; j < last; ++j) {
      const a = rows[i] + j;
      const b = rows[i + 1] + j;
      faces.push(a, b, a + 1);
      if (kind === 'tensor' || j + 1 < last) faces.push(b, b + 1, a + 1);
    }
  }
  return { at, faces };
}

const minus = ([x, y], [a, b]) => [x - a, y - b];
const heights = (points, [x, y]) => points.map(([u, v]) => u * y - v * x);
/** Whether a triangle and a segment have a point in common: no line along a side of either separates them. */
function meet(triangle, segment) {
  const sides = [...triangle.map((p, k) => minus(p, triangle[(k + 1) % 3])), minus(...segment)];
  return sides.every((side) => {
    const [one, two] = [triangle, segment].map((points) => heights(points, side));
    return Math.max(...one) >= Math.min(...two) && Math.max(...two) >= Math.min(...one);
  });
}
/** Whether an odd number of loops is around a point: a ray along u crosses an odd number of segments. */
const isInside = (segments, [u, v]) => segments.filter(([[a, b], [c, d]]) => b > v !== d > v && u < a + ((v - b) / (d - b)) * (c - a)).length % 2 === 1;

/** The triangles of a grid that a trim (segments of all loops) leaves, in parameters as the grid's: {at, faces}.
 * Triangles on its border are halved, and stay where their middle is inside. */
export function trimmed({ at, faces }, segments) {
  const places = new Map();
  const kept = { at: [], faces: [] };
  const indexOf = (p) => {
    const key = p.join();
    if (!places.has(key)) places.set(key, kept.at.push(p) - 1);
    return places.get(key);
  };
  const take = (triangle, near, halvings) => {
    const met = near.filter((segment) => meet(triangle, segment));
    if (met.length > 0 && halvings > 0) {
      const middles = triangle.map((p, k) => p.map((x, i) => (x + triangle[(k + 1) % 3][i]) / 2));
      const parts = [...triangle.map((p, k) => [p, middles[k], middles[(k + 2) % 3]]), middles];
      for (const part of parts) take(part, met, halvings - 1);
    } else if (isInside(segments, [0, 1].map((k) => (triangle[0][k] + triangle[1][k] + triangle[2][k]) / 3))) {
      kept.faces.push(...triangle.map(indexOf));
    }
  };
  for (let i = 0; i < faces.length; i += 3) take(faces.slice(i, i + 3).map((v) => at[v]), segments, kTrimHalvings);
  return kept;
}

/** {count, faces, normals, places}: places(dt) are its points at t* + dt. faces are triangles, three indices each;
 * without any it is a chain of lines, or a point. normals are those of a body that is round, or null. */
export function surfaceOf({ patch, corners: [o, eu, ev] }) {
  if (patch.mesh) {
    const { at, faces, normals } = patch.mesh;
    const [{ v }] = patch.terms;
    return { count: at.length, faces, normals, places: (dt) => at.map((p) => p.map((x, k) => x + dt * v[k])) };
  }
  const whole = grid(patch.shape);
  const uv = whole.at.map(([x, y]) => o.map((begin, k) => begin + x * (eu[k] - begin) + y * (ev[k] - begin)));
  const left = patch.trim ? trimmed({ at: uv, faces: whole.faces }, patch.trim) : { at: uv, faces: whole.faces };
  // Where the eye sees nothing of what is left, it sees the point of the contact.
  const at = left.at.length > 0 ? left.at : [[0, 0]];
  return { count: at.length, faces: left.faces, normals: null, places: (dt) => at.map((place) => evaluate(patch, ...place, dt)) };
}
