#!/usr/bin/env node
// node gltf.mjs CASE.json -o OUT.gltf: writes a case as glTF, with the whole step as an animation, as the
// button of the report's page does. Needs what `npm ci` installs. Exits with 2 for what is no case.
import { readFileSync, writeFileSync } from 'node:fs';
import { parseArgs } from 'node:util';
import { cellAt, localOf, pictureOf } from './src/geometry.js';
import { gltfText } from './src/gltf.js';
import { centreOf, indices, motionOf, real, shapeOf } from './src/local.js';

// three.js reads its buffer through this class of browsers, which Node does not have.
globalThis.FileReader = class {
  async readAsDataURL(blob) {
    const bytes = Buffer.from(await blob.arrayBuffer());
    this.result = `data:application/octet-stream;base64,${bytes.toString('base64')}`;
    this.onloadend();
  }
};

const kShapes = ['point', 'curve', 'triangle', 'tensor', 'hull'];
const kMaxDegree = 8;
const kMostPoints = 81;
const expect = (holds, what) => {
  if (!holds) throw new Error(what);
};

/** Throws an error that says what is wrong unless patches and t_max are those of a case. */
function checkCase(known) {
  expect(known?.format === 'ccdfuzz-case', 'format is not "ccdfuzz-case"');
  expect(real(known.t_max) > 0 && Number.isFinite(real(known.t_max)), 't_max is not a positive number');
  expect(Array.isArray(known.patches) && known.patches.length === 2, 'patches: there are not two');
  known.patches.forEach((patch, s) => {
    expect(kShapes.includes(patch.shape), `patches[${s}].shape is none of ${kShapes.join(', ')}`);
    const { n, m, kind } = shapeOf(patch);
    expect(kind === 'hull' || [n, m].every((x) => Number.isInteger(x) && x >= 0 && x <= kMaxDegree), `patches[${s}].degree is not from 0 to ${kMaxDegree}`);
    const isBody = kind === 'hull';
    expect(isBody === (known.patches[0].shape === 'hull'), 'patches: one is a body and one is not');
    const points = isBody ? patch.positions?.length : indices({ kind, n, m }).length;
    expect(!isBody || (points >= 1 && points <= kMostPoints), `patches[${s}].positions does not have 1 to ${kMostPoints} rows`);
    expect(!isBody || (real(patch.radius ?? 0) >= 0 && Number.isFinite(real(patch.radius ?? 0))), `patches[${s}].radius is not a number of at least 0`);
    expect(!patch.weights || (patch.weights.length === points && patch.weights.every((w) => real(w) > 0 && Number.isFinite(real(w)))),
      `patches[${s}].weights is not a positive number for each control point`);
    const loops = patch.trim ?? [];
    expect(loops.every((loop) => loop.length >= 3 && loop.every((at) => at.length === 2 && at.every((x) => Number.isFinite(real(x))))),
      `patches[${s}].trim has a loop that is not three pairs of numbers or more`);
    for (const name of ['positions', motionOf(patch)]) {
      const rows = patch[name];
      const count = isBody && name === 'velocities' ? 1 : points;
      expect(rows?.length === count, `patches[${s}].${name} does not have as many rows as ${isBody ? 'a body needs' : 'control points'}`);
      expect(rows.every((row) => row.length === 3 && row.every((x) => Number.isFinite(real(x)))), `patches[${s}].${name} has a row that is not three numbers`);
    }
  });
}

const usage = 'usage: node gltf.mjs CASE.json -o OUT.gltf';
let place = usage;
try {
  const { values, positionals } = parseArgs({ options: { output: { type: 'string', short: 'o' } }, allowPositionals: true });
  expect(positionals.length === 1 && values.output, 'takes one case and one file to write');
  [place] = positionals;
  const known = JSON.parse(readFileSync(place, 'utf8'));
  checkCase(known);
  const centre = centreOf(known);
  const local = localOf(known, centre);
  const whole = (s, level) => cellAt(local.patches[s].shape, centre.uv[s], level);
  const text = await gltfText(centre, local.origin, pictureOf(local, real(known.t_max), 0, whole));
  place = values.output;
  writeFileSync(place, text);
} catch (error) {
  console.error(`gltf.mjs: ${place}: ${error.message}`);
  process.exit(2);
}
