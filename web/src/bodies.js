// Bodies: all that is within a radius of the convex hull of points. Their contact, and meshes of them.
import { IcosahedronGeometry, Vector3 } from 'three';
import { ConvexHull } from 'three/addons/math/ConvexHull.js';
import { add, compare, fractionOf, multiply, parseFraction, subtract, toNumber } from './exact.js';
import { real } from './local.js';
import { turnedAt } from './turn.js';

const kFlat = 2 ** -20;  // of a body's size: what is thinner is drawn as flat
const kTie = 2 ** -40;  // of a body's size: heights that differ by less are of one face or edge
const kAround = 32;  // directions around an edge, and around the contact's normal
const kDetail = 9;  // of the sphere: 1,002 directions
export const kDeepestOfBodies = 10;  // the surface at the contact is as fine as 2^-10 of the radius

const dot = (a, b) => a.reduce((sum, x, k) => sum + x * b[k], 0);
const minus = (a, b) => a.map((x, k) => x - b[k]);
const along = (a, factor, b) => a.map((x, k) => x + factor * b[k]);
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
/** As a unit vector; null for 0. */
const unit = (a) => {
  const length = Math.hypot(...a);
  return length > 0 ? a.map((x) => x / length) : null;
};
/** Two unit vectors at right angles to a unit vector and to each other. */
function beside(axis) {
  const least = axis.map(Math.abs).indexOf(Math.min(...axis.map(Math.abs)));
  const one = unit(cross(axis, [0, 1, 2].map((k) => (k === least ? 1 : 0))));
  return [one, cross(axis, one)];
}
/** The direction that a triangle faces; null if it has no area. */
const normalOf = (points, face) => {
  const [p, q, r] = face.map((i) => points[i]);
  return unit(cross(minus(q, p), minus(r, p)));
};
/** The element of the greatest value. */
const most = (list, value) => list.reduce((a, b) => (value(b) > value(a) ? b : a));

/** The triangles of the convex hull as triples of indices; flat points have one side, and others none. */
export function hullFaces(points) {
  const from = points.map((p) => minus(p, points[0]));
  const size = Math.max(...from.flat().map(Math.abs));
  const all = from.map((p) => p.map((x) => x / size));
  const far = most(all, (p) => Math.hypot(...minus(p, all[0])));
  const edge = unit(minus(far, all[0]));
  if (!edge) return [];
  const offLine = (p) => Math.hypot(...cross(minus(p, all[0]), edge));
  const third = most(all, offLine);
  if (offLine(third) <= kFlat) return [];
  const normal = unit(cross(edge, minus(third, all[0])));
  const isFlat = all.every((p) => Math.abs(dot(minus(p, all[0]), normal)) <= kFlat);
  // Flat points are the base of a pyramid.
  const middle = [0, 1, 2].map((k) => (all[0][k] + far[k] + third[k]) / 3);
  const vectors = [...all, ...(isFlat ? [along(middle, 1, normal)] : [])].map((p) => new Vector3(...p));
  const index = new Map(vectors.map((v, i) => [v, i]));
  return new ConvexHull().setFromPoints(vectors).faces
    .map(({ edge: first }) => [first.prev, first, first.next].map((e) => index.get(e.vertex.point)))
    .filter((face) => face.every((i) => i < points.length));
}

/** The edges of a hull with those triangles as pairs of indices, without those inside of a flat side. */
function edgesOf(points, faces) {
  if (faces.length === 0) {
    const farthest = (from) => most([...points.keys()], (i) => Math.hypot(...minus(points[i], points[from])));
    const one = farthest(0);
    const two = farthest(one);
    return one === two ? [] : [[one, two]];
  }
  const found = new Map();
  for (const face of faces) {
    const normal = normalOf(points, face);
    face.forEach((i, k) => {
      const pair = [i, face[(k + 1) % 3]].sort((a, b) => a - b);
      const key = pair.join();
      found.set(key, { pair, normals: [...(found.get(key)?.normals ?? []), normal] });
    });
  }
  return [...found.values()].filter(({ normals: [one, two] }) => !one || !two || dot(one, two) < 1 - kFlat).map(({ pair }) => pair);
}

const turn = (k) => (2 * Math.PI * k) / kAround;
const ring = (axis, sine = 1) => {
  const [one, two] = beside(axis);
  const circle = Array.from({ length: kAround }, (_, k) => along(one.map((x) => Math.cos(turn(k)) * x), Math.sin(turn(k)), two));
  return circle.map((d) => along(axis.map((x) => Math.sqrt(1 - sine * sine) * x), sine, d));
};
const sphere = (() => {
  const { array } = new IcosahedronGeometry(1, kDetail).getAttribute('position');
  const all = Array.from({ length: array.length / 3 }, (_, i) => [...array.slice(3 * i, 3 * i + 3)]);
  return [...new Map(all.map((d) => [d.map((x) => x.toFixed(3)).join(), unit(d)])).values()];
})();

/**
 * A body's surface, {at, faces, normals, net}: its points, triangles and normals (null where sides are flat), and
 * the edges of the hull. Every point is on the surface. Sides and edges are as they are; the round rest is
 * finer the nearer to `normal`, a unit vector or null. The triangles of a mesh are `given`. A point or a segment without a radius has no triangles.
 */
export function bodyMesh(points, radius, normal, given) {
  const faces = given ?? hullFaces(points);
  const net = edgesOf(points, faces);
  const sharp = { at: faces.length > 0 ? points : (net[0] ?? [0]).map((i) => points[i]), faces: faces.flat(), normals: null, net };
  if (radius === 0) return sharp;
  const size = Math.max(radius, ...points.flat().map(Math.abs));
  const directions = [
    ...sphere,
    ...faces.map((face) => normalOf(points, face)).filter(Boolean).flatMap((d) => [d, d.map((x) => -x)]),
    ...net.map(([i, j]) => unit(minus(points[j], points[i]))).filter(Boolean).flatMap((edge) => ring(edge)),
    ...(normal ? [normal, ...Array.from({ length: kDeepestOfBodies }, (_, k) => ring(normal, 2 ** -(k + 1))).flat()] : []),
  ];
  const at = [];
  const normals = [];
  for (const d of directions) {
    const heights = points.map((p) => dot(p, d));
    const top = Math.max(...heights);
    points.forEach((p, i) => {
      if (top - heights[i] > kTie * size) return;
      at.push(along(p, radius, d));
      normals.push(d);
    });
  }
  const round = hullFaces(at);
  // A radius that is nothing beside the points' distances is not drawn.
  return round.length > 0 ? { at, faces: round.flat(), normals, net } : sharp;
}

const exact = (x) => fractionOf(real(x));
const sum = (list) => list.reduce(add, [0n, 1n]);

/**
 * Two bodies about their contact, as localPatches has patches: each with its one term, the point of its surface
 * that is nearest to the other, and with `points`, `radius` and `mesh` besides. `normal` is the direction from
 * body 1 to body 2 there. Without a witness it is that of the middles, and so are the points. A body that turns
 * is drawn as it stands at t, also before and after.
 */
export function localBodies(known, { uv, t, witness }) {
  const bodies = known.patches.map((patch, s) => {
    const v = patch.velocities[0].map(exact);
    const turn = patch.turn ?? patch.spin;
    const turned = turn ? turnedAt(turn, t) : (point) => point;
    const points = patch.positions.map((row) => turned(row.map(exact)).map((x, k) => add(x, multiply(t, v[k]))));
    const share = witness ? known.truth.witness.weights[s].map(parseFraction) : points.map(() => [1n, BigInt(points.length)]);
    const place = [0, 1, 2].map((k) => sum(points.map((p, i) => multiply(share[i], p[k]))));
    return { v, points, place, radius: exact(patch.radius ?? 0) };
  });
  const [one, two] = bodies;
  const gap = two.place.map((x, k) => subtract(x, one.place[k]));
  const radii = add(one.radius, two.radius);
  const apart = witness && compare(sum(gap.map((x) => multiply(x, x))), multiply(radii, radii)) !== 0;
  const { kind, normal: proven } = known.truth?.certificate?.clear ?? {};
  const between = gap.map(toNumber);
  const normal = unit(between) ?? (kind === 'K' ? unit(proven.map((x) => toNumber(parseFraction(x)))) : null);
  const along1 = (factor) => (normal ?? [0, 0, 0]).map((x) => factor * x);
  const length = witness && !apart ? 0 : Math.hypot(...between) - (witness ? toNumber(radii) : 0);
  const mean = one.v.map((x, k) => multiply(add(x, two.v[k]), [1n, 2n]));
  const inner = witness ? along1(toNumber(one.radius)) : [0, 0, 0];
  return {
    patches: bodies.map(({ v, points, radius }, s) => {
      const local = points.map((p) => minus(p.map((x, k) => toNumber(subtract(x, one.place[k]))), inner));
      const outward = normal?.map((x) => (s === 0 ? x : -x)) ?? null;
      return {
        shape: { kind: 'hull', n: 0, m: 0 },
        terms: [{ a: 0, b: 0, p: s === 0 ? [0, 0, 0] : along1(length), v: v.map((x, k) => toNumber(subtract(x, mean[k]))), w: 1 }],
        points: local, radius: toNumber(radius), normal: outward, mesh: bodyMesh(local, toNumber(radius), outward, known.patches[s].faces),
      };
    }),
    origin: one.place.map((x, k) => toNumber(x) + inner[k]),
    apart, uv, t, normal,
  };
}
