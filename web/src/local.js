// Two moving patches as polynomials about one point and one time, relative to it: the coefficients
// are computed exactly and rounded once, so that any zoom is as sharp as doubles are.
import { fractionOf, multiply, parseFraction, partsOf, subtract, toNumber } from './exact.js';

const factorials = [1];
for (let n = 1; n <= 32; ++n) factorials.push(factorials[n - 1] * n);
const binomial = (n, k) => factorials[n] / (factorials[k] * factorials[n - k]);

/** Degrees and names of a patch of the case format. */
export function shapeOf(patch) {
  if (patch.shape === 'tensor') return { kind: 'tensor', n: patch.degree[0], m: patch.degree[1] };
  return { kind: patch.shape, n: patch.shape === 'point' ? 0 : patch.degree, m: 0 };
}

/** Pairs (i, j) of the control points, in their order. */
export function indices({ kind, n, m }) {
  const all = [];
  for (let i = 0; i <= n; ++i) {
    const last = kind === 'triangle' ? n - i : m;
    for (let j = 0; j <= last; ++j) all.push([i, j]);
  }
  return all;
}

/** How often (i, j) stands in the expansion of its polynomial. */
function weight({ kind, n, m }, i, j) {
  if (kind === 'triangle') return factorials[n] / (factorials[i] * factorials[j] * factorials[n - i - j]);
  return binomial(n, i) * binomial(m, j);
}

/** Reals of the case format: numbers or hex-float strings. */
export function real(x) {
  if (typeof x === 'number') return x;
  const match = /^([+-]?)0x([0-9a-f]*)\.?([0-9a-f]*)p([+-]?\d+)$/i.exec(x);
  if (!match) return Number(x);
  const [, sign, whole, fraction, exponent] = match;
  const digits = Number(BigInt(`0x${whole}${fraction}`));
  const power = Number(exponent) - 4 * fraction.length;
  const half = Math.trunc(power / 2);
  return (sign === '-' ? -1 : 1) * digits * 2 ** half * 2 ** (power - half);
}

/** All coordinates as integers of one unit 2^exponent. */
function integers(rows, exponent) {
  return rows.map((row) =>
    row.map((x) => {
      const [m, e] = partsOf(x);
      return m << BigInt(m === 0n ? 0 : e - exponent);
    }),
  );
}

function leastExponent(...lists) {
  let least = 0;
  for (const rows of lists) for (const row of rows) for (const x of row) if (x !== 0) least = Math.min(least, partsOf(x)[1]);
  return least;
}

/** One step of de Casteljau on integers along a chain; weights of the two ends. */
const mix = (p, q, a, b) => p.map((x, k) => x * a + q[k] * b);

/** The blossom of integer points: a steps along u, b along v as directions, the rest at u, v (over
 * the common denominator). */
function blossom({ kind, n, m }, points, a, b, u, v, one) {
  let net = points;
  if (kind === 'triangle') {
    for (let left = n, step = 0; left > 0; --left, ++step) {
      const [wu, wv, ww] =
        step < a ? [1n, 0n, -1n] : step < a + b ? [0n, 1n, -1n] : [u, v, one - u - v];
      const at = (i, j, d) => i * (d + 1) - (i * (i - 1)) / 2 + j;
      const next = [];
      for (let i = 0; i < left; ++i) {
        for (let j = 0; j < left - i; ++j) {
          const pw = net[at(i, j, left)];
          const pv = net[at(i, j + 1, left)];
          const pu = net[at(i + 1, j, left)];
          next.push(pw.map((x, k) => x * ww + pv[k] * wv + pu[k] * wu));
        }
      }
      net = next;
    }
    return net[0];
  }
  const rows = [];
  for (let i = 0; i <= n; ++i) {
    let row = net.slice(i * (m + 1), (i + 1) * (m + 1));
    for (let step = 0; row.length > 1; ++step) {
      const [p, q] = step < b ? [-1n, 1n] : [one - v, v];
      row = row.slice(1).map((next, k) => mix(row[k], next, p, q));
    }
    rows.push(row[0]);
  }
  let column = rows;
  for (let step = 0; column.length > 1; ++step) {
    const [p, q] = step < a ? [-1n, 1n] : [one - u, u];
    column = column.slice(1).map((next, k) => mix(column[k], next, p, q));
  }
  return column[0];
}

/** How many of the steps at (a, b) are regular, each of which multiplies by the denominator. */
function regularSteps({ kind, n, m }, a, b) {
  return kind === 'triangle' ? n - a - b : n - a + m - b;
}

/** The key of a patch that says how it moves: its velocities, or its positions at t = 1. */
export const motionOf = (patch) => (patch.ends ? 'ends' : 'velocities');

/** The edges of all loops of a trim, as offsets from uv; rounded after the subtraction. */
const segmentsOf = (trim, uv) => trim.flatMap((loop) => {
  const at = loop.map((vertex) => vertex.map((x, k) => toNumber(subtract(fractionOf(real(x)), uv[k]))));
  return at.map((p, i) => [p, at[(i + 1) % at.length]]);
});

/** Homogeneous: a point is p / w, and w is 1 for a patch without weights. At uv and t, w is 1. */
function expand(patch, uv, t) {
  const shape = shapeOf(patch);
  const positions = patch.positions.map((row) => row.map(real));
  const motion = patch[motionOf(patch)].map((row) => row.map(real));
  const weights = patch.positions.map((_, i) => [real(patch.weights?.[i] ?? 1)]);
  const exponent = leastExponent(positions, motion);
  const w = integers(weights, leastExponent(weights));
  const p = integers(positions, exponent);
  const given = integers(motion, exponent);
  const v = patch.ends ? given.map((row, i) => row.map((x, k) => x - p[i][k])) : given;
  const moved = p.map((row, i) => row.map((x, k) => (x * t[1] + v[i][k] * t[0]) * w[i][0]));
  const heavy = v.map((row, i) => row.map((x) => x * w[i][0]));
  const one = uv[0][1] * uv[1][1];
  const at = [uv[0][0] * uv[1][1], uv[1][0] * uv[0][1]];
  const unit = 1n << BigInt(-exponent);
  const [whole] = blossom(shape, w, 0, 0, at[0], at[1], one);
  const steps = BigInt(regularSteps(shape, 0, 0));
  const terms = indices(shape).map(([a, b]) => {
    const many = BigInt(Math.round(weight(shape, a, b))) * one ** (steps - BigInt(regularSteps(shape, a, b)));
    const fraction = (points, denominator) =>
      blossom(shape, points, a, b, at[0], at[1], one).map((x) => [x * many, whole * denominator]);
    return { a, b, p: fraction(moved, unit * t[1]), v: fraction(heavy, unit), w: fraction(w, 1n)[0] };
  });
  return { shape, terms, trim: patch.trim ? segmentsOf(patch.trim, uv) : null };
}

/**
 * Both patches of a case about uv[0], uv[1] and t (fractions): point = Σ duᵃ dvᵇ (p + dt·v) / Σ duᵃ dvᵇ w,
 * relative to patch 0's point there and moving along with the mean of both velocities. `apart` says that
 * the two points differ there, exactly.
 */
export function localPatches({ patches }, { uv, t }) {
  const [one, two] = patches.map((patch, s) => expand(patch, uv[s], t));
  const origin = one.terms[0].p;
  const gap = two.terms[0].p.map((x, k) => subtract(x, origin[k]));
  const velocity = one.terms[0].v.map((x, k) => {
    const other = two.terms[0].v[k];
    return [x[0] * other[1] + other[0] * x[1], 2n * x[1] * other[1]];
  });
  const without = (row, moved, w) => row.map((x, k) => toNumber(w[0] === 0n ? x : subtract(x, multiply(moved[k], w))));
  const rounded = ({ shape, terms, trim }) => ({
    shape,
    trim,
    terms: terms.map(({ a, b, p, v, w }) => ({ a, b, p: without(p, origin, w), v: without(v, velocity, w), w: toNumber(w) })),
  });
  return {
    patches: [rounded(one), rounded(two)],
    origin: origin.map(toNumber),
    apart: gap.some(([p]) => p !== 0n),
    uv,
    t,
  };
}

/** The point at (du, dv, dt) from the centre. */
export function evaluate({ terms }, du, dv, dt) {
  const out = [0, 0, 0];
  let weight = 0;
  for (const { a, b, p, v, w } of terms) {
    const factor = du ** a * dv ** b;
    for (let k = 0; k < 3; ++k) out[k] += factor * (p[k] + dt * v[k]);
    weight += factor * w;
  }
  return out.map((x) => x / weight);
}

/** Corners (origin, end of u, end of v) of a cell of a level, as offsets from the centre; rounded
 * after the subtraction. */
export function cellCorners({ kind }, [i, j, inverted], level, uv) {
  const ends = inverted
    ? [[i + 1, j + 1], [i, j + 1], [i + 1, j]]
    : [[i, j], [i + 1, j], [i, j + 1]];
  return ends.map((corner) =>
    corner.map((x, k) => {
      if (kind === 'point' || kind === 'hull' || (kind === 'curve' && k === 1)) return 0;
      return toNumber(subtract([BigInt(x), 1n << BigInt(level)], uv[k]));
    }),
  );
}

/** Control points {p, v, w} of the part of a local patch over a cell. */
export function partOf({ shape, terms }, corners) {
  const [o, eu, ev] = corners;
  const { n, m } = shape;
  // In du = o + x·(eu − o) + y·(ev − o): the monomials of x and y.
  const linear = (k) => [
    { x: 0, y: 0, c: o[k] },
    { x: 1, y: 0, c: eu[k] - o[k] },
    { x: 0, y: 1, c: ev[k] - o[k] },
  ];
  const times = (f, g) => {
    const out = new Map();
    for (const s of f) for (const t of g) {
      const key = `${s.x + t.x},${s.y + t.y}`;
      const found = out.get(key);
      if (found) found.c += s.c * t.c;
      else out.set(key, { x: s.x + t.x, y: s.y + t.y, c: s.c * t.c });
    }
    return [...out.values()].filter((t) => t.c !== 0);
  };
  const powers = (k, most) => {
    const all = [[{ x: 0, y: 0, c: 1 }]];
    for (let e = 1; e <= most; ++e) all.push(times(all[e - 1], linear(k)));
    return all;
  };
  const ofU = powers(0, n);
  const ofV = powers(1, shape.kind === 'triangle' ? n : m);
  const monomials = new Map();
  for (const { a, b, p, v, w } of terms) {
    for (const { x, y, c } of times(ofU[a], ofV[b])) {
      const key = `${x},${y}`;
      if (!monomials.has(key)) monomials.set(key, { x, y, p: [0, 0, 0], v: [0, 0, 0], w: 0 });
      const sum = monomials.get(key);
      sum.w += c * w;
      for (let k = 0; k < 3; ++k) {
        sum.p[k] += c * p[k];
        sum.v[k] += c * v[k];
      }
    }
  }
  return indices(shape).map(([i, j]) => {
    const out = { p: [0, 0, 0], v: [0, 0, 0], w: 0 };
    for (const { x, y, p, v, w } of monomials.values()) {
      if (x > i || y > j) continue;
      const share = (binomial(i, x) * binomial(j, y)) / weight(shape, x, y);
      for (let k = 0; k < 3; ++k) {
        out.p[k] += share * p[k];
        out.v[k] += share * v[k];
      }
      out.w += share * w;
    }
    return { p: out.p.map((x) => x / out.w), v: out.v.map((x) => x / out.w), w: out.w };
  });
}

const kNowhere = [['0', '0'], ['0', '0']];  // bodies have no parameters

/** The centre to draw a case about: its witness or, without one, the middle of both patches at
 * the end of the step. */
export function centreOf(known) {
  const witness = known.truth?.witness;
  if (witness) {
    return {
      uv: (witness.uv ?? kNowhere).map((pair) => pair.map(parseFraction)),
      t: parseFraction(witness.t),
      witness: true,
    };
  }
  const middle = known.patches.map((patch) => {
    if (patch.shape === 'triangle') return [[1n, 3n], [1n, 3n]];
    if (patch.shape === 'tensor') return [[1n, 2n], [1n, 2n]];
    return [[patch.shape === 'curve' ? 1n : 0n, 2n], [0n, 1n]];
  });
  return { uv: middle, t: fractionOf(real(known.t_max)), witness: false };
}
