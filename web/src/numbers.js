// The exact numbers beside the picture.
import { h, scientific } from './dom.js';
import { real } from './local.js';
import { compare, fractionOf, hexFloat, toNumber } from './exact.js';

/** A table of the contact, of how a method answered, and of its loss, if it has lost it. */
export function numbersTable({ known, centre, local, tMax, method, answer, loss }) {
  const rows = [];
  const add = (label, ...value) => rows.push(h('tr', h('th', { scope: 'row' }, label), h('td', ...value)));
  const witness = known.truth?.witness;
  const noun = known.patches[0].shape === 'hull' ? 'body' : 'patch';
  if (witness) {
    add('t*', h('code', witness.t), ` ≈ ${toNumber(centre.t)}`);
    witness.uv?.forEach((pair, s) => add(`u, v of patch ${s + 1}`, h('code', pair.join(', '))));
    witness.weights?.forEach((share, s) => add(`weights of the points of body ${s + 1}`, h('code', share.join(', '))));
    add('contact point', h('code', local.origin.map((x) => String(x)).join(', ')));
    if (local.apart) add('', known.separation ? `${noun} 1; ${noun} 2 keeps a distance` : `the ${known.truth.witness.uv ? 'two patches differ' : 'hulls are nearer than their radii'} there`);
  }
  const clear = known.truth?.certificate?.clear;
  if (clear) add('no contact before', h('code', known.truth.clear_until), `, by certificate ${clear.kind}`);
  known.patches.forEach(({ radius }, s) => radius && add(`radius of body ${s + 1}`, h('code', hexFloat(real(radius))), ` = ${real(radius)}`));
  if (known.separation) add('separation', h('code', hexFloat(real(known.separation))), ` = ${real(known.separation)}`);
  add('t_max', h('code', hexFloat(tMax)), ` = ${tMax}`);
  if (answer?.toi !== null && answer?.toi !== undefined) add(`toi of ${method}`, h('code', hexFloat(answer.toi)), ` = ${answer.toi}`);
  if (loss) {
    add('lost in', `level ${loss.level}, cells ${loss.cells.map(([i, j, inv]) => `(${i}, ${j}${inv ? ', inverted' : ''})`).join(' and ')}`);
    add('window', h('code', loss.window.map(hexFloat).join(' … ')));
    if (loss.axis !== undefined) {
      add(`axis ${loss.axis}`, h('code', loss.direction.map(hexFloat).join(', ')));
      const [cutLo, cutHi] = loss.cut;
      add('excluded', h('code', `${cutLo ? '[' : '('}${loss.excluded.map(hexFloat).join(', ')}${cutHi ? ']' : ')'}`),
        compare(fractionOf(loss.excluded[1]), centre.t) === 0 ? ' t* is its end' : ' holds t*');
      if (loss.overlap !== null) add('exact overlap at t*', `${scientific(loss.overlap, 6)} (an ulp of the heights is ${scientific(loss.height_ulp, 3)})`);
    }
    add('left of the window', h('code', loss.left ? loss.left.map(hexFloat).join(' … ') : 'nothing'));
  }
  if (known.origin?.note) add('note', known.origin.note);
  return h('table', h('tbody', rows));
}
