// Where the eye is, and how large what it sees is.
import { fractionOf, subtract, toNumber, ulpOf } from './exact.js';
import { localBodies } from './bodies.js';
import { cellCorners, localPatches, partOf } from './local.js';
import { surfaceOf } from './surface.js';

/** A case about its contact (centreOf), patches or bodies. */
export const localOf = (known, centre) =>
  (known.patches[0].shape === 'hull' ? localBodies : localPatches)(known, centre);

/** The cell of a level that holds the centre, the lowest one if several do. */
export function cellAt({ kind }, uv, level) {
  if (kind === 'point' || kind === 'hull') return [0, 0, 0];
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
/** How large a part is at a magnification; a body, which has no parts, is nearer instead. */
const sizeOf = ({ patch, controls }, zoom) => (patch.mesh ? (largest(controls) + patch.radius) * 2 ** -zoom : largest(controls));
/** How fast the patches approach at the centre, per unit of time. */
export const relativeSpeed = ([a, b]) => Math.hypot(...a.terms[0].v.map((x, k) => x - b.terms[0].v[k]));

/** The corners of a cell of a patch about the centre, and the control points of that part. */
export function cellOfPatch(patch, level, cell, uv) {
  const corners = cellCorners(patch.shape, cell, level, uv);
  if (patch.mesh) return { corners, controls: patch.points.map((p) => ({ p, v: patch.terms[0].v })) };
  return { corners, controls: partOf(patch, corners) };
}

/** What is in sight at magnification `zoom`: of each patch the part in the cell cellOf(side, zoom), the
 * largest of their coordinates, and the times before and after the centre's that stay in sight. */
export function pictureOf({ patches, uv, t }, tMax, zoom, cellOf) {
  const parts = patches.map((patch, s) => {
    const part = { patch, ...cellOfPatch(patch, zoom, cellOf(s, zoom), uv[s]) };
    return { ...part, surface: surfaceOf(part) };
  });
  const scale = Math.max(...parts.map((part) => sizeOf(part, zoom))) || 1;
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
