// Turns of bodies, in fractions: by a quaternion, or by a cosine and a sine about the z axis.
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

/** Where a turn brings a point at t, before the body moves. */
export function turnedAt({ from, to, centre = [0, 0, 0] }, t) {
  const middle = centre.map(exact);
  const q = from.map((x, i) => add(multiply(subtract([1n, 1n], t), exact(x)), multiply(t, exact(to[i]))));
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
