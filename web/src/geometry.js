// Where the eye is, and how large what it sees is.
import { fractionOf, subtract, toNumber, ulpOf } from './exact.js';
import { cellCorners, partOf } from './local.js';

/** The cell of a level that holds the centre, the lowest one if several do. */
export function cellAt({ kind }, uv, level) {
  if (kind === 'point') return [0, 0, 0];
  const size = 1n << BigInt(level);
  const lowest = ([p, q]) => {
    const k = (p * size) / q;
    const exact = k * q === p * size;
    return exact && k > 0n ? k - 1n : k;
  };
  let [i, j] = uv.map(lowest);
  if (kind !== 'triangle') return [Number(i), kind === 'curve' ? 0 : Number(j), 0];
  const [[p, q], [r, s]] = uv;
  const past = (p * s + r * q) * size > (i + j + 1n) * q * s;
  return [Number(i), Number(j), past ? 1 : 0];
}

export const largest = (controls) => Math.max(0, ...controls.flatMap(({ p }) => p.map(Math.abs)));
/** How fast the patches approach at the centre, per unit of time. */
export const relativeSpeed = ([a, b]) => Math.hypot(...a.terms[0].v.map((x, k) => x - b.terms[0].v[k]));

/** The corners of a cell of a patch about the centre, and the control points of that part. */
export function cellOfPatch(patch, level, cell, uv) {
  const corners = cellCorners(patch.shape, cell, level, uv);
  return { corners, controls: partOf(patch, corners) };
}

/** What is in sight at magnification `zoom`: of each patch the part in the cell cellOf(side, zoom), the
 * largest of their coordinates, and the times before and after the centre's that stay in sight. */
export function pictureOf({ patches, uv, t }, tMax, zoom, cellOf) {
  const parts = patches.map((patch, s) => ({ patch, ...cellOfPatch(patch, zoom, cellOf(s, zoom), uv[s]) }));
  const scale = Math.max(...parts.map(({ controls }) => largest(controls))) || 1;
  const speed = relativeSpeed(patches);
  const reach = zoom === 0 || !(speed > 0) ? Infinity : (0.6 * scale) / speed;
  const lo = Math.max(-toNumber(t), -reach);
  const hi = Math.min(toNumber(subtract(fractionOf(tMax), t)), reach);
  return { parts, scale, range: hi > lo ? [lo, hi] : [lo, lo + (ulpOf(toNumber(t)) || 1)] };
}

export function unit(axis) {
  const most = Math.max(...axis.map(Math.abs));
  const scaled = axis.map((x) => x / most);
  const length = Math.hypot(...scaled);
  return scaled.map((x) => x / length);
}
