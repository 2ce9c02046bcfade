// One patch as three.js shows it: its surface, its control net, and the boxes about its parts. Everything
// comes in local coordinates and is divided by `scale` before it becomes single precision.
import {
  BoxGeometry, BufferAttribute, BufferGeometry, Color, DoubleSide, EdgesGeometry, Group, LineBasicMaterial,
  LineSegments, Matrix4, Mesh, MeshBasicMaterial, MeshPhongMaterial, Points, PointsMaterial, Vector3,
} from 'three';
import { indices } from './local.js';

export const kPatchColours = [0x3f7fbf, 0xe08a2e];

const kFar = 8;

/** Lines of a control net: pairs of places in the order of the control points. */
export function netEdges({ kind, n, m }) {
  const place = new Map(indices({ kind, n, m }).map(([i, j], at) => [`${i},${j}`, at]));
  const edges = [];
  for (const [key, at] of place) {
    const [i, j] = key.split(',').map(Number);
    for (const [x, y] of [[i + 1, j], [i, j + 1], ...(kind === 'triangle' ? [[i + 1, j - 1]] : [])]) {
      const to = place.get(`${x},${y}`);
      if (to !== undefined) edges.push(at, to);
    }
  }
  return edges;
}

export const vector = (p, scale) => new Vector3(p[0] / scale, p[1] / scale, p[2] / scale);
export const cross = (a, b) => new Vector3().crossVectors(a, b);

/** A patch: its surface over a part of the domain, the net and points of that part, and its box; or a body. */
export class PatchView {
  constructor({ patch, corners, controls, boxes, surface }, colour) {
    this.patch = patch;
    this.corners = corners;
    this.places = surface.places;
    this.controls = controls;
    this.group = new Group();
    const { count, faces, normals } = surface;
    this.surface = new BufferGeometry();
    this.surface.setAttribute('position', new BufferAttribute(new Float32Array(3 * count), 3));
    if (normals) this.surface.setAttribute('normal', new BufferAttribute(new Float32Array(normals.flat()), 3));
    this.bends = faces.length > 0 && !patch.mesh;
    if (faces.length > 0) {
      this.surface.setIndex(faces);
      this.group.add(new Mesh(this.surface, new MeshPhongMaterial({
        color: colour, emissive: colour, emissiveIntensity: 0.28, side: DoubleSide, transparent: true,
        opacity: patch.mesh ? 0.7 : 0.86, flatShading: Boolean(patch.mesh && !normals), shininess: 30, specular: 0x222222, polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1,
      })));
    } else if (count > 1) {
      const line = [];
      for (let i = 0; i + 1 < count; ++i) line.push(i, i + 1);
      this.surface.setIndex(line);
      this.group.add(new LineSegments(this.surface, new LineBasicMaterial({ color: colour })));
    } else {
      this.group.add(new Points(this.surface,
        new PointsMaterial({ color: colour, size: 9, sizeAttenuation: false })));
    }
    this.net = new BufferGeometry();
    this.net.setAttribute('position', new BufferAttribute(new Float32Array(3 * controls.length), 3));
    this.lines = new BufferGeometry();
    this.lines.setAttribute('position', this.net.getAttribute('position'));
    this.lines.setIndex(patch.mesh?.net.flat() ?? netEdges(patch.shape));
    const dark = new Color(colour).lerp(new Color(0x000000), 0.25);
    this.netGroup = new Group();
    if (this.lines.index.count > 0) {
      this.netGroup.add(new LineSegments(this.lines,
        new LineBasicMaterial({ color: dark, transparent: true, opacity: 0.75 })));
    }
    this.netGroup.add(new Points(this.net,
      new PointsMaterial({ color: dark, size: 6, sizeAttenuation: false })));
    this.group.add(this.netGroup);
    this.boxes = boxes.map(({ controls: of, faint }) => {
      const box = new Group();
      const unit = new BoxGeometry(1, 1, 1);
      box.add(new LineSegments(new EdgesGeometry(unit), new LineBasicMaterial({
        color: colour, transparent: true, opacity: faint ? 0.3 : 1,
      })));
      if (!faint) {
        box.add(new Mesh(unit, new MeshBasicMaterial({
          color: colour, transparent: true, opacity: 0.1, depthWrite: false, side: DoubleSide,
        })));
      }
      box.matrixAutoUpdate = false;
      this.group.add(box);
      return { box, controls: of };
    });
  }

  controlPoints(controls, dt, scale) {
    return controls.map(({ p, v }) => vector(p.map((x, k) => x + dt * v[k]), scale));
  }

  move(dt, boxDt, scale) {
    const places = this.surface.getAttribute('position');
    this.places(dt).forEach((p, index) => places.setXYZ(index, p[0] / scale, p[1] / scale, p[2] / scale));
    places.needsUpdate = true;
    if (this.bends) this.surface.computeVertexNormals();
    this.surface.computeBoundingSphere();
    const net = this.net.getAttribute('position');
    const points = this.controlPoints(this.controls, dt, scale);
    points.forEach((p, index) => net.setXYZ(index, p.x, p.y, p.z));
    net.needsUpdate = true;
    this.net.computeBoundingSphere();
    this.lines.computeBoundingSphere();
    for (const { box, controls } of this.boxes) {
      this.placeBox(box, this.controlPoints(controls, dt, scale), this.controlPoints(controls, boxDt, scale));
    }
  }

  /** The box of the control points along the axes that Appendix A (c) takes from the patch itself. */
  placeBox(box, points, at) {
    const { kind, n, m } = this.patch.shape;
    const place = (i, j) => indices({ kind, n, m }).findIndex(([x, y]) => x === i && y === j);
    const along = (i, j) => at[Math.max(place(i, j), 0)].clone().sub(at[0]);
    const u = along(n, 0);
    const v = kind === 'triangle' ? along(0, n) : along(0, m);
    let first = u.clone().normalize();
    let second = cross(u, v).normalize();
    if (first.length() < 0.5) first = new Vector3(1, 0, 0);
    if (second.length() < 0.5) {
      second = cross(first, Math.abs(first.x) < 0.9 ? new Vector3(1, 0, 0) : new Vector3(0, 1, 0)).normalize();
    }
    const third = cross(first, second);
    const axes = [first, second, third];
    const centre = new Vector3();
    const sizes = axes.map((axis) => {
      const heights = points.map((p) => p.dot(axis));
      // What is far outside of the picture is cut off: single precision would blur what is in it.
      const lo = Math.max(-kFar, Math.min(...heights));
      const hi = Math.min(kFar, Math.max(...heights));
      centre.addScaledVector(axis, (lo + hi) / 2);
      return Math.max(hi - lo, 1e-6);
    });
    box.matrix.copy(new Matrix4().makeTranslation(centre.x, centre.y, centre.z)
      .multiply(new Matrix4().makeBasis(...axes))
      .multiply(new Matrix4().makeScale(...sizes)));
    box.matrixWorldNeedsUpdate = true;
  }

  dispose() {
    this.group.traverse((one) => {
      one.geometry?.dispose();
      one.material?.dispose();
    });
  }
}
