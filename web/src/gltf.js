// A picture of a case with its motion, as other programs open it.
import { AnimationClip, DoubleSide, MeshStandardMaterial, NumberKeyframeTrack, Object3D, Scene } from 'three';
import { GLTFExporter } from 'three/addons/exporters/GLTFExporter.js';
import { toNumber } from './exact.js';
import { kPatchColours, PatchView } from './patch_view.js';

const kComfortable = 2 ** 14;  // lengths up to this and from its inverse on stay as they are

/** The power of two that brings all control points at the ends of the range into single precision. */
function unitOf({ parts, range }) {
  const lengths = parts.flatMap(({ patch, controls }) => controls.flatMap(({ p, v }) =>
    range.flatMap((dt) => p.map((x, k) => Math.abs(x + dt * v[k]) + (patch.radius ?? 0)))));
  const most = Math.max(...lengths);
  if (!Number.isFinite(most)) throw new RangeError('the patches leave the range of doubles within the step');
  return most === 0 || (most <= kComfortable && most >= 1 / kComfortable) ? 1 : 2 ** Math.floor(Math.log2(most));
}

/** Gives a direction to the normals of triangles without an area: glTF has unit normals only. */
function makeUnit(normals) {
  for (let i = 0; i < normals.count; ++i) {
    if (normals.getX(i) === 0 && normals.getY(i) === 0 && normals.getZ(i) === 0) normals.setZ(i, 1);
  }
}

/**
 * A picture (pictureOf) about a centre, at `origin`, as glTF 2.0: one JSON text with its buffer in it. It has the
 * surfaces, the control nets, a node at the contact if there is one, and an animation of a second
 * over the picture's range of times. Points move linearly, so the shapes at both ends say it exactly.
 * The scene's `extras` say what the coordinates are relative to and what they are divided by.
 */
export async function gltfText(centre, origin, picture) {
  const { parts, range } = picture;
  const unit = unitOf(picture);
  const scene = new Scene();
  const tracks = [];
  parts.forEach((part, s) => {
    const [first, last] = range.map((dt) => {
      const view = new PatchView({ ...part, boxes: [] }, kPatchColours[s]);
      view.move(dt, dt, unit);
      return view;
    });
    const moved = [];
    last.group.traverse((one) => moved.push(one));
    first.group.traverse((one) => {
      const { geometry } = moved.shift();
      if (!geometry) return;
      for (const [name, attribute] of Object.entries(geometry.attributes)) {
        if (name === 'normal') [one.geometry.attributes.normal, attribute].forEach(makeUnit);
        one.geometry.morphAttributes[name] = [attribute];
      }
      one.updateMorphTargets();
      one.material = new MeshStandardMaterial({ color: one.material.color, roughness: 0.6, side: DoubleSide });
      one.name = `${part.patch.mesh ? 'body' : 'patch'} ${s + 1}${one.parent !== first.netGroup ? '' : part.patch.mesh ? ', hull' : ', control net'}`;
      tracks.push(new NumberKeyframeTrack(`${one.uuid}.morphTargetInfluences`, [0, 1], [0, 1]));
    });
    scene.add(first.group);
  });
  if (centre.witness) {
    const contact = new Object3D();
    contact.name = 'contact';
    scene.add(contact);
  }
  scene.userData = { origin, unit, t: toNumber(centre.t), times: range };
  const animations = [new AnimationClip('the step', 1, tracks)];
  return JSON.stringify(await new GLTFExporter().parseAsync(scene, { animations }));
}
