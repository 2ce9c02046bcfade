// The surface of a part of a patch or of a body, as triangles or lines, for all that draws or cuts it.
import { evaluate } from './local.js';

const kSteps = 28;

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

/** {count, faces, normals, places}: places(dt) are its points at t* + dt. faces are triangles, three indices each;
 * without any it is a chain of lines, or a point. normals are those of a body that is round, or null. */
export function surfaceOf({ patch, corners: [o, eu, ev] }) {
  if (patch.mesh) {
    const { at, faces, normals } = patch.mesh;
    const [{ v }] = patch.terms;
    return { count: at.length, faces, normals, places: (dt) => at.map((p) => p.map((x, k) => x + dt * v[k])) };
  }
  const { at, faces } = grid(patch.shape);
  const uv = at.map(([x, y]) => o.map((begin, k) => begin + x * (eu[k] - begin) + y * (ev[k] - begin)));
  return { count: at.length, faces, normals: null, places: (dt) => uv.map((place) => evaluate(patch, ...place, dt)) };
}
