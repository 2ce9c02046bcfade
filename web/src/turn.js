// Turns of bodies, in fractions: by a quaternion, by a cosine and a sine about the z axis, or by an angular velocity.
import { add, fractionOf, multiply, subtract } from './exact.js';
import { real } from './local.js';

const exact = (x) => fractionOf(real(x));
const sum = (list) => list.reduce(add, [0n, 1n]);
const opposite = ([p, q]) => [-p, q];
const divide = (a, [p, q]) => multiply(a, [q, p]);

function integerRoot(n) {
  if (n < 2n) return n;
  let root = 1n << BigInt((n.toString(2).length + 1) >> 1);
  for (let next = (root + n / root) >> 1n; next < root; next = (root + n / root) >> 1n) root = next;
  return root;
}

/** The root of a fraction > 0: exact where it is a fraction, else to 64 bits. */
function rootOf([p, q]) {
  const bits = 64n;  // √(p/q) = √(p·q·4^bits) / (q·2^bits)
  return [integerRoot((p * q) << (2n * bits)), q << bits];
}

/** The quaternion of a spin at t: of doubles, and a little off. */
function quaternionOf(spin, t) {
  const u = spin.map((x) => (real(x) * Number(t[0] * 2n ** 64n / t[1])) / 2 ** 65);
  const angle = Math.hypot(...u);
  return [Math.cos(angle), ...u.map((x) => (angle > 0 ? (x * Math.sin(angle)) / angle : 0))].map(fractionOf);
}

/** Where a turn, or a spin of this velocity, brings a point at t, before the body moves. */
export function turnedAt({ from, to, velocity, centre = [0, 0, 0] }, t) {
  const middle = centre.map(exact);
  const q = velocity ? quaternionOf(velocity, t) : from.map((x, i) => add(multiply(subtract([1n, 1n], t), exact(x)), multiply(t, exact(to[i]))));
  const squared = sum(q.map((x) => multiply(x, x)));
  const [w, x, y, z] = q;
  const twice = (a, b) => multiply([2n, 1n], multiply(a, b));
  const diagonal = (k) => sum(q.map((a, i) => (i === 0 || i === k + 1 ? multiply(a, a) : opposite(multiply(a, a)))));
  const rows = q.length === 4
    ? [[diagonal(0), subtract(twice(x, y), twice(w, z)), add(twice(x, z), twice(w, y))],
       [add(twice(x, y), twice(w, z)), diagonal(1), subtract(twice(y, z), twice(w, x))],
       [subtract(twice(x, z), twice(w, y)), add(twice(y, z), twice(w, x)), diagonal(2)]]
    : [[w, opposite(x), [0n, 1n]], [x, w, [0n, 1n]], [[0n, 1n], [0n, 1n], rootOf(squared)]];
  const length = q.length === 4 ? squared : rootOf(squared);
  return (point) => rows.map((row, k) =>
    add(middle[k], divide(sum(row.map((a, i) => multiply(a, subtract(point[i], middle[i])))), length)));
}
