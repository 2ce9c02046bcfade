// Exact numbers as BigInt fractions: what makes a gap of 1e-15 visible is that offsets from the
// witness are rounded once, after all cancellation.

/** A double as [numerator, exponent]: numerator·2^exponent, exactly. */
export function partsOf(x) {
  if (x === 0) return [0n, 0];
  const view = new DataView(new ArrayBuffer(8));
  view.setFloat64(0, x);
  const bits = view.getBigUint64(0);
  const field = Number((bits >> 52n) & 0x7ffn);
  const fraction = bits & 0xfffffffffffffn;
  const mantissa = field === 0 ? fraction : fraction | 0x10000000000000n;
  return [bits >> 63n ? -mantissa : mantissa, Math.max(field, 1) - 1075];
}

/** "p/q" or "p" as [p, q]. */
export function parseFraction(text) {
  const [p, q = '1'] = String(text).split('/');
  return [BigInt(p), BigInt(q)];
}

/** A double as a fraction [p, q]. */
export function fractionOf(x) {
  const [m, e] = partsOf(x);
  return e >= 0 ? [m << BigInt(e), 1n] : [m, 1n << BigInt(-e)];
}

const bitLength = (n) => (n < 0n ? -n : n).toString(16).length * 4;

/** p/q as a double, within an ulp; exact where it is a double of 53 bits in the normal range. */
export function toNumber([p, q]) {
  if (p === 0n) return 0;
  const shift = bitLength(p) - bitLength(q) - 64;
  const quotient = shift >= 0 ? p / (q << BigInt(shift)) : (p << BigInt(-shift)) / q;
  // Twice, so that no factor alone leaves the range of doubles.
  const half = Math.trunc(shift / 2);
  return Number(quotient) * 2 ** half * 2 ** (shift - half);
}

export const add = ([p, q], [r, s]) => [p * s + r * q, q * s];
export const multiply = ([p, q], [r, s]) => [p * r, q * s];
export const subtract = ([p, q], [r, s]) => [p * s - r * q, q * s];
export const compare = ([p, q], [r, s]) => {
  const d = p * s - r * q;
  return d < 0n ? -1 : d > 0n ? 1 : 0;
};

/** Steps from a double to the next, as an unsigned distance between two of the same sign. */
export function ulpOf(x) {
  const a = Math.abs(x);
  if (a < 2 ** -1022) return 2 ** -1074;
  return 2 ** (Math.floor(Math.log2(a)) - 52);
}

/** The double as C++ and the case format write it: 0x1.8p-3. */
export function hexFloat(x) {
  if (!Number.isFinite(x)) return String(x);
  if (x === 0) return Object.is(x, -0) ? '-0x0p+0' : '0x0p+0';
  const view = new DataView(new ArrayBuffer(8));
  view.setFloat64(0, x);
  const bits = view.getBigUint64(0);
  const field = Number((bits >> 52n) & 0x7ffn);
  const fraction = (bits & 0xfffffffffffffn).toString(16).padStart(13, '0').replace(/0+$/, '');
  const exponent = field === 0 ? -1022 : field - 1023;
  const sign = x < 0 ? '-' : '';
  const lead = field === 0 ? '0' : '1';
  return `${sign}0x${lead}${fraction && '.'}${fraction}p${exponent < 0 ? '' : '+'}${exponent}`;
}
