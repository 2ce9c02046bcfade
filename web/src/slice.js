// A plane through the contact, and where it cuts both patches: shows in 2-D that they meet there.
import { compare } from './exact.js';
import { unit } from './geometry.js';

const kSlant = 2 ** -10;  // sine of an angle that moves no line of a picture of 1,000 pixels by one
const kTurns = 12;  // planes of a quarter turn: steps of 7.5 degrees
const kOnPlane = 2 ** -20;  // of the picture's size: a thousandth of a pixel of it

const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const minus = (a, b) => a.map((x, k) => x - b[k]);
const along = (a, factor, b) => a.map((x, k) => x + factor * b[k]);
/** As a unit vector; null for what has no direction. */
const direction = (a) => (a?.every(Number.isFinite) && a.some((x) => x !== 0) ? unit(a) : null);
/** Of the direction what is at right angles to a unit vector, as a unit vector; null if they are parallel. */
const besides = (a, axis) => {
  const one = direction(a);
  const rest = one && along(one, -dot(one, axis), axis);
  return rest && Math.hypot(...rest) > kSlant ? unit(rest) : null;
};

/** Directions in parameters of the edges that (u, v) lies on; of a curve's inside, the curve itself. */
function edgesAt({ kind, n }, [u, v]) {
  const is = (x, k) => compare(x, [k, 1n]) === 0;
  if (kind === 'point' || n === 0) return [[0, 0], [0, 0]];
  if (kind === 'curve') return is(u, 0n) || is(u, 1n) ? [[1, 0], [1, 0]] : [[1, 0]];
  const edges = [];
  if (is(u, 0n) || (kind === 'tensor' && is(u, 1n))) edges.push([0, 1]);
  if (is(v, 0n) || (kind === 'tensor' && is(v, 1n))) edges.push([1, 0]);
  if (kind === 'triangle' && is([u[0] * v[1] + v[0] * u[1], u[1] * v[1]], 1n)) edges.push([1, -1]);
  return edges;
}

/** A patch at the contact: what touches there, and its directions. */
function touching({ shape, terms }, uv) {
  const slope = (a, b) => {
    const found = terms.find((term) => term.a === a && term.b === b);
    return found ? along(found.p, -found.w, terms[0].p) : [0, 0, 0];
  };
  const [du, dv] = [slope(1, 0), slope(0, 1)];
  const edges = (shape.kind === 'hull' ? [] : edgesAt(shape, uv)).map(([a, b]) => du.map((x, k) => a * x + b * dv[k]));
  const [u, v] = [direction(du), direction(dv)];
  return {
    dimension: 2 - Math.min(2, edges.length),
    edge: edges.length === 1 ? direction(edges[0]) : null,
    normal: u && besides(dv, u) && direction(cross(u, v)),
  };
}

/** The contact's normal: the gap between both points where they keep a distance, or else the normal of a face,
 * of two edges, or of an edge against the velocity. */
function contactNormal({ patches, uv, normal }, velocity) {
  if (normal) return normal;
  const both = patches.map((patch, s) => touching(patch, uv[s]));
  const face = both.find(({ dimension, normal }) => dimension === 2 && normal);
  const edges = both.map(({ edge }) => edge).filter(Boolean);
  return direction(minus(patches[1].terms[0].p, patches[0].terms[0].p)) ?? face?.normal ??
    (edges.length === 2 && besides(edges[1], edges[0]) ? direction(cross(...edges)) : null) ??
    (edges.length > 0 ? besides(velocity, edges[0]) : null) ??
    direction(velocity) ?? both.find(({ normal }) => normal)?.normal ?? [0, 0, 1];
}

/** Points of a part at dt, as seen from a point that moves with `velocity`, and its triangles. */
const placesOf = ({ surface: { faces, places } }, dt, velocity) =>
  ({ places: places(dt).map((p) => along(p, -dt, velocity)), faces });

/** Where a plane {across, up, out} cuts what placesOf gives: {segments: [[x1, y1, x2, y2]], points: [[x, y]],
 * shadow: segments}, divided by scale. The shadow is that of a curve, seen across the plane. */
function cutBy({ across, up, out }, part, scale) {
  const { faces } = part;
  const places = part.places.map((p) => [across, up, out].map((axis) => dot(p, axis) / scale));
  const isOn = (i) => Math.abs(places[i][2]) <= kOnPlane;
  /** The points of a chain of nodes on the plane: nodes, and crossings between two. */
  const cut = (nodes, pairs) => [...nodes.filter(isOn).map((i) => places[i]),
    ...pairs.filter(([i, j]) => !isOn(i) && !isOn(j) && places[i][2] > 0 !== places[j][2] > 0).map(([i, j]) => {
      const [a, b] = [places[i], places[j]];
      const share = a[2] / (a[2] - b[2]);
      return a.map((x, k) => x + share * (b[k] - x));
    })];
  const segments = [];
  const points = [];
  const shadow = [];
  const segment = (a, b) => [a[0], a[1], b[0], b[1]];
  const flat = new Map();  // edges of triangles that lie in the plane, and of how many
  for (let f = 0; f < faces.length; f += 3) {
    const nodes = faces.slice(f, f + 3);
    const pairs = [0, 1, 2].map((k) => [nodes[k], nodes[(k + 1) % 3]]);
    const found = cut(nodes, pairs);
    if (found.length === 2) segments.push(segment(...found));
    if (found.length < 3) continue;
    for (const [i, j] of pairs) {
      const key = `${Math.min(i, j)},${Math.max(i, j)}`;
      flat.set(key, { count: (flat.get(key)?.count ?? 0) + 1, ends: [i, j] });
    }
  }
  for (const { count, ends } of flat.values()) if (count === 1) segments.push(segment(...ends.map((i) => places[i])));
  if (places.length === 1) points.push(places[0].slice(0, 2));
  else if (faces.length === 0) {
    places.slice(1).forEach((place, i) => {
      shadow.push(segment(places[i], place));
      const found = cut([i, i + 1], [[i, i + 1]]);
      if (found.length === 2) segments.push(segment(...found));
      else points.push(...found.map(([x, y]) => [x, y]));
    });
  }
  return { segments, points, shadow };
}

/** Twice the area of a triangle, > 0 if it turns left. */
const turnOf = ([x, y], [x1, y1], [x2, y2]) => (x1 - x) * (y2 - y) - (x2 - x) * (y1 - y);
/** A convex polygon, or none if it has no area. */
const withArea = (polygon) => {
  const area = polygon.reduce((sum, p, i) => sum + turnOf(polygon[0], p, polygon[(i + 1) % polygon.length]), 0);
  return area > kOnPlane ** 2 ? polygon : [];
};

/** The convex polygon around a section of a body, counterclockwise; empty if it has no area. */
export function convexOf({ segments }) {
  const all = segments.flatMap(([a, b, c, d]) => [[a, b], [c, d]]);
  const middle = [0, 1].map((k) => all.reduce((sum, p) => sum + p[k], 0) / all.length);
  const angle = (p) => Math.atan2(p[1] - middle[1], p[0] - middle[0]);
  return withArea(all.map((p) => [angle(p), p]).sort(([a], [b]) => a - b).map(([, p]) => p));
}

/** What two convex polygons have in common: the first, cut along each side of the second. */
export function overlapOf(one, two) {
  if (two.length === 0) return [];
  return withArea(two.reduce((left, from, i) => {
    const to = two[(i + 1) % two.length];
    return left.flatMap((p, k) => {
      const q = left[(k + 1) % left.length];
      const [a, b] = [p, q].map((x) => turnOf(from, to, x));
      const crossing = a < 0 !== b < 0 ? [p.map((x, at) => x + (a / (a - b)) * (q[at] - x))] : [];
      return [...(a >= 0 ? [p] : []), ...crossing];
    });
  }, one));
}

const lengthOf = (segments) => Math.max(0, ...segments.flat().map(Math.abs));

/** How much of the patch that it shows less of a plane shows, of the patch's size. */
function shownBy(plane, parts, scale) {
  return Math.min(...parts.filter(({ places }) => places.length > 1).map((part) => {
    const size = Math.max(...part.places.flat().map(Math.abs)) / scale;
    return lengthOf(cutBy(plane, part, scale).segments) / size;
  }));
}

/**
 * The plane to cut through patch 1's point of the contact, {across, up, out} as unit vectors. Of the planes
 * that hold the velocity of patch 2 against patch 1, it is the one nearest to the contact's normal that shows
 * enough of both patches: half of what the best does. A last choice is the plane through the middles of both.
 * `up` is the contact's normal or what is nearest to it, and patch 2 comes down.
 */
export function sliceFrame(local, { parts, scale }, middles) {
  const [one, two] = local.patches.map(({ terms }) => terms[0]);
  const velocity = minus(two.v, one.v);
  const toMiddle = middles.map((middle, s) => minus(middle, [one, two][s].p));
  const normal = contactNormal(local, velocity);
  const axis = direction(velocity) ?? normal;
  const beside = [normal, ...toMiddle, [1, 0, 0], [0, 1, 0]].map((one) => besides(one, axis)).find(Boolean);
  const turned = Array.from({ length: 2 * kTurns }, (_, k) => {
    const angle = ((k % 2 ? -1 : 1) * Math.ceil(k / 2) * Math.PI) / (2 * kTurns);
    return cross(axis, beside).map((x, i) => Math.cos(angle) * x - Math.sin(angle) * beside[i]);
  });
  const [u, v] = toMiddle.map(direction);
  const through = u && v && besides(v, u) && direction(cross(u, v));
  const planes = [...turned, through].filter(Boolean).map((out) => {
    const up = besides(normal, out) ?? besides(axis, out);
    const signed = dot(velocity, up) > 0 ? up.map((x) => -x) : up;
    return { across: cross(signed, out), up: signed, out, velocity, holdsMotion: out !== through, holdsNormal: Math.abs(dot(normal, out)) < kSlant };
  });
  const places = parts.map((part) => placesOf(part, 0, one.v));
  const shown = planes.map((plane) => shownBy(plane, places, scale));
  return planes[shown.findIndex((share) => share >= Math.max(...shown) / 2)] ?? planes[0];
}

/** Where the plane cuts a part at dt, as cutBy says it, seen from a point that moves with `velocity`. */
export const sectionOf = (part, plane, dt, scale, velocity) => cutBy(plane, placesOf(part, dt, velocity), scale);

/** What a slice shows, of the picture's size: from the contact to the farthest line of the smaller section,
 * or without a contact of the larger one. */
export function extentOf(sections, witness) {
  const extents = sections.map(({ segments, shadow }) => lengthOf([...segments, ...shadow]));
  const seen = extents.filter((x) => x > kOnPlane);
  return witness ? Math.min(...seen, 1) : Math.max(...seen, kOnPlane);
}

/** Times around the contact, or null: from when on before it patch 2 is followed, and until when after it. The
 * contact comes from a third of what `size` lengths show. */
export function beforeAndAfter(range, { velocity }, size, late) {
  const reach = size / 3 / Math.hypot(...velocity);
  const before = Math.max(range[0], -reach);
  const after = late > 0 ? late : Math.min(range[1], reach);
  return [before < 0 ? before : null, after > 0 ? after : null].map((dt) => (Number.isFinite(dt) ? dt : null));
}

export const middleOf = (controls) => [0, 1, 2].map((k) => controls.reduce((sum, { p }) => sum + p[k], 0) / controls.length);
export const pastOf = ({ velocity, up }, dt) => -dot(velocity, up) * dt;
