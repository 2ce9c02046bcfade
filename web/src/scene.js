// The two patches in 3-D.
import {
  AmbientLight, ArrowHelper, BufferGeometry, DirectionalLight, DoubleSide, Group, LineBasicMaterial, LineSegments, Mesh, MeshBasicMaterial, PerspectiveCamera,
  PlaneGeometry, Quaternion, Scene, SphereGeometry, Vector3, WebGLRenderer,
} from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { evaluate } from './local.js';
import { cross, kPatchColours, PatchView, vector } from './patch_view.js';

export class Stage {
  constructor(canvas) {
    this.canvas = canvas;
    this.renderer = new WebGLRenderer({ canvas, antialias: true, alpha: true, preserveDrawingBuffer: true });
    this.scene = new Scene();
    this.camera = new PerspectiveCamera(35, 1, 0.01, 100);
    this.camera.position.set(2.4, 1.7, 3.1);
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.enableDamping = false;
    this.controls.listenToKeyEvents(canvas);
    this.controls.keyPanSpeed = 12;
    this.controls.addEventListener('change', () => this.draw());
    this.scene.add(new AmbientLight(0xffffff, 1.1));
    const key = new DirectionalLight(0xffffff, 1.6);
    key.position.set(2, 4, 3);
    this.camera.add(key);
    this.scene.add(this.camera);
    this.views = [];
    this.marks = new Group();
    this.scene.add(this.marks);
    this.show = { nets: true, boxes: true, normals: true };
    this.colours = { patches: kPatchColours };
    this.resize();
    new ResizeObserver(() => this.resize()).observe(canvas.parentElement);
  }

  resize() {
    const { clientWidth, clientHeight } = this.canvas.parentElement;
    if (clientWidth === 0 || clientHeight === 0) return;
    this.renderer.setPixelRatio(Math.min(globalThis.devicePixelRatio || 1, 2));
    this.renderer.setSize(clientWidth, clientHeight, false);
    this.camera.aspect = clientWidth / clientHeight;
    this.camera.updateProjectionMatrix();
    this.draw();
  }

  /** parts: for each side {patch, corners, controls, boxes: [{controls, faint}]}; axis: unit direction or null. */
  load(parts, { scale, axis, axisFailed, witness, separation, boxDt }) {
    for (const view of this.views) {
      this.scene.remove(view.group);
      view.dispose();
    }
    const style = getComputedStyle(this.canvas);
    for (const name of ['ink', 'alarm']) this.colours[name] = style.getPropertyValue(`--${name}`).trim();
    this.scale = scale;
    this.boxDt = boxDt;
    this.views = parts.map((part, s) => new PatchView(part, this.colours.patches[s]));
    for (const view of this.views) this.scene.add(view.group);
    this.axis = axis;
    this.axisFailed = axisFailed;
    this.witness = witness;
    this.separation = separation / scale;
    this.applyShow();
  }

  applyShow() {
    for (const view of this.views) {
      view.netGroup.visible = this.show.nets;
      for (const { box } of view.boxes) box.visible = this.show.boxes;
    }
  }

  /** The patches at t* + dt. */
  move(dt) {
    this.dt = dt;
    for (const view of this.views) view.move(dt, this.boxDt, this.scale);
    this.placeMarks(dt);
    this.draw();
  }

  placeMarks(dt) {
    this.marks.traverse((one) => {
      one.geometry?.dispose();
      one.material?.dispose();
    });
    this.marks.clear();
    const at = this.views.map(({ patch }) => vector(evaluate(patch, 0, 0, dt), this.scale));
    const dot = (p, colour, radius) => {
      const ball = new Mesh(new SphereGeometry(radius, 20, 14), new MeshBasicMaterial({ color: colour, depthTest: false }));
      ball.renderOrder = 5;
      ball.position.copy(p);
      this.marks.add(ball);
    };
    if (this.witness) at.forEach((p, s) => dot(p, s === 0 ? this.colours.ink : this.colours.patches[1], s === 0 ? 0.022 : 0.015));
    if (this.separation > 0 && this.witness) {
      // What counts as a contact: all within the separation of the first one's point.
      const ball = new Mesh(new SphereGeometry(this.separation, 40, 28),
        new MeshBasicMaterial({ color: this.colours.ink, transparent: true, opacity: 0.12, depthWrite: false }));
      ball.position.copy(at[0]);
      this.marks.add(ball, new LineSegments(new BufferGeometry().setFromPoints(at), new LineBasicMaterial({ color: this.colours.ink, depthTest: false })));
    }
    if (this.show.normals && this.witness) {
      const arrow = (n, s) => this.marks.add(new ArrowHelper(n.normalize(), at[s], 0.5, this.colours.patches[s], 0.09, 0.05));
      this.views.forEach(({ patch, corners }, s) => {
        if (patch.normal) return arrow(new Vector3(...patch.normal), s);
        if (patch.mesh || patch.shape.kind === 'point' || patch.shape.kind === 'curve') return;
        const h = Math.max(...corners.flat().map(Math.abs)) * 1e-3;
        const o = evaluate(patch, 0, 0, dt);
        const minus = (p) => vector(p.map((x, k) => x - o[k]), this.scale);
        const n = cross(minus(evaluate(patch, h, 0, dt)), minus(evaluate(patch, 0, h, dt)));
        if (n.length() > 0) arrow(n, s);
      });
    }
    if (this.axis) {
      const direction = new Vector3(...this.axis).normalize();
      const middle = at[0].clone().add(at[1]).multiplyScalar(0.5);
      const colour = this.axisFailed ? this.colours.alarm : this.colours.ink;
      for (const sign of [1, -1]) {
        this.marks.add(new ArrowHelper(direction.clone().multiplyScalar(sign), middle, 0.75, colour, 0.1, 0.055));
      }
      if (this.axisFailed) {
        const plane = new Mesh(new PlaneGeometry(1.7, 1.7), new MeshBasicMaterial({
          color: colour, transparent: true, opacity: 0.13, side: DoubleSide, depthWrite: false,
        }));
        plane.position.copy(middle);
        plane.quaternion.copy(new Quaternion().setFromUnitVectors(new Vector3(0, 0, 1), direction));
        this.marks.add(plane);
      }
    }
  }

  /** Looks at the plane across an axis, from `elevation` above it: 0 is edge-on. */
  lookAcross(axis, elevation) {
    const direction = new Vector3(...axis).normalize();
    let side = cross(direction, new Vector3(0, 1, 0));
    if (side.length() < 0.2) side = cross(direction, new Vector3(1, 0, 0));
    side.normalize();
    this.camera.up.copy(direction);
    this.camera.position.copy(side.addScaledVector(direction, elevation).setLength(4.3));
    this.controls.target.set(0, 0, 0);
    this.controls.update();
    this.draw();
  }

  reset(target = [0, 0, 0], distance = 4.3) {
    this.camera.up.set(0, 1, 0);
    this.controls.target.set(...target);
    this.camera.position.set(2.4, 1.7, 3.1).setLength(distance).add(this.controls.target);
    this.controls.update();
    this.draw();
  }

  draw() {
    this.renderer.render(this.scene, this.camera);
  }
}
