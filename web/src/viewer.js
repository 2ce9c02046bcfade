// One case to watch: patches in 3-D, time, the boxes along the trace, and the exact numbers.
import { details } from './data.js';
import { copyButton, fileName, h, saveButton, scientific } from './dom.js';
import { toNumber, ulpOf, fractionOf, subtract } from './exact.js';
import { kDeepestOfBodies } from './bodies.js';
import { cellAt, cellOfPatch, largest, localOf, pictureOf, relativeSpeed, unit } from './geometry.js';
import { gltfText } from './gltf.js';
import { centreOf, real, shapeOf } from './local.js';
import { numbersTable } from './numbers.js';
import { SliceView } from './slice_view.js';
import { bands, ladder } from './timeline.js';
import { heightsPlot, marginPlot } from './trace_plots.js';
import { verdict } from './verdict.js';
import { Stage } from './scene.js';
import { colourOf } from './colours.js';

const kDeepest = 50;

const bodyName = ({ positions: { length }, radius }) =>
  (length === 1 && radius ? 'ball' : length === 2 && radius ? 'capsule' : `${radius ? 'rounded ' : ''}body of ${length} ${length > 1 ? 'points' : 'point'}`);
const worth = ({ outcome }) => ['missed', 'late', 'false_positive', 'error'].includes(outcome) ? 0 : 1;
const failuresFirst = ([, a], [, b]) => worth(a) - worth(b);
export class Viewer {
  constructor(root) {
    this.root = root;
    this.canvas = h('canvas', { tabindex: 0, role: 'img', 'aria-label': 'Both patches or bodies; drag or use the arrow keys to turn, the wheel or + and − to zoom' });
    this.slider = h('input.time', { type: 'range', min: 0, max: 1000, step: 'any', 'aria-label': 'Time' });
    this.zoom = h('input.zoom', { type: 'range', min: 0, max: kDeepest, step: 1, 'aria-label': 'Magnification' });
    this.timeText = h('output.time-text');
    this.zoomText = h('output.zoom-text');
    this.track = h('div.track', { 'aria-hidden': 'true' });
    this.ladder = h('div.ladder', { role: 'group', 'aria-label': 'Levels of subdivision' });
    this.sentence = h('p.sentence', { 'aria-live': 'polite' });
    this.heading = h('h3.case-title');
    this.chips = h('div.chips', { role: 'group', 'aria-label': 'Methods' });
    this.plots = h('div.trace-plots');
    this.numbers = h('div.numbers');
    this.buttons = h('div.buttons');
    this.toggles = h('div.toggles');
    this.scaleText = h('div.scale');
    this.views = h('div.views', h('div.stage', this.canvas, this.toggles, this.scaleText));
    this.slice = new SliceView(this.views, () => `${fileName(this.row.id)}-slice`);
    root.append(
      h('header.case-head', this.heading, this.chips, this.sentence),
      this.views,
      h('div.controls',
        h('div.row.of-patches', h('span.label', 'Level'), this.ladder),
        h('div.row', h('span.label', 'Time'), h('div.time-box', this.track, this.slider), this.timeText),
        h('div.row', h('span.label', 'Zoom'), this.zoom, this.zoomText)),
      this.plots, this.numbers, this.buttons);
    this.slider.addEventListener('input', () => this.setTime(Number(this.slider.value) / 1000));
    this.zoom.addEventListener('input', () => this.setZoom(Number(this.zoom.value)));
    this.makeToggles();
    document.addEventListener('ccdfuzz:theme', () => this.case && this.select(this.method, this.level));
  }

  makeToggles() {
    const toggle = (key, label) => {
      const button = h('button', { type: 'button', 'aria-pressed': 'true' }, label);
      button.addEventListener('click', () => {
        const on = button.getAttribute('aria-pressed') !== 'true';
        button.setAttribute('aria-pressed', String(on));
        if (!this.stage) return;
        this.stage.show[key] = on;
        this.stage.applyShow();
        this.stage.move(this.dt);
      });
      return button;
    };
    const view = (label, title, act) => h('button', { type: 'button', title, onclick: act }, label);
    const ofPatches = (button) => button.classList.add('of-patches') ?? button;
    this.toggles.append(
      toggle('nets', 'Nets'), ofPatches(toggle('boxes', 'Boxes')), toggle('normals', 'Normals'),
      view('Whole', 'Both, from the start', () => this.setZoom(0)),
      view('Side', 'Across the axis or the normals', () => this.lookAside()),
      ofPatches(view('Gap', 'As near as the error is large', () => this.zoomToGap())));
  }

  /** Shows a case; of its methods the one asked for, or else the one that lost most. */
  async open(row, method) {
    this.row = row;
    const found = await details(row.index);
    if (this.row !== row) return;
    this.case = found.case;
    this.details = found;
    this.areBodies = this.case.patches[0].shape === 'hull';
    this.root.classList.toggle('of-bodies', this.areBodies);
    this.zoom.max = this.areBodies ? kDeepestOfBodies : kDeepest;
    try {
      this.stage ??= new Stage(this.canvas);
    } catch {
      this.stage = null;
      this.root.classList.add('no-webgl');
      this.scaleText.textContent = 'No 3-D here: this browser has no WebGL.';
    }
    this.centre = centreOf(this.case);
    this.local = localOf(this.case, this.centre);
    this.tStar = toNumber(this.centre.t);
    this.tMax = real(this.case.t_max);
    this.separation = real(this.case.separation ?? 0);
    this.fillHead();
    const worst = row.worst ?? {};
    const other = this.traceOf(worst.method) ?? found.traces.find((t) => t.lost) ?? found.traces[0];
    const chosen = found.answers[method] ? method : other?.method ?? row.failed[0];
    this.select(chosen, this.traceOf(chosen)?.loss?.level ?? 0);
    if (this.stage?.axis ?? this.local.normal) this.stage?.lookAcross(this.stage.axis ?? this.local.normal, 0.75);
    else this.stage?.reset();
    this.fillButtons();
  }

  traceOf(method) {
    return this.details.traces.find((t) => t.method === method);
  }

  fillHead() {
    const { contact, kind, generator, id, isNew } = this.row;
    const { separation } = this;
    const shapes = this.case.patches.map((p) => {
      const s = shapeOf(p);
      return (p.trim ? 'trimmed ' : '') + (p.weights ? 'rational ' : '') + (s.kind === 'tensor' ? `tensor ${s.n}×${s.m}` : s.kind === 'point' ? 'point'
        : s.kind === 'hull' ? bodyName(p) : `${s.kind} of degree ${s.n}`);
    });
    this.heading.replaceChildren(...[
      h('span.class-tag', contact || '–'), ` ${kind} · ${shapes.join(' against ')} `,
      separation > 0 ? h('span.separation', `separation ${scientific(separation, 6)}`) : null,
      h('span.faint', `${generator}${isNew === true ? ' · new' : isNew === false ? ' · known before' : ''}`),
      h('span.case-id', { title: id }, id.length > 44 ? `…${id.slice(-43)}` : id)].filter(Boolean));
  }

  fillChips() {
    this.chips.replaceChildren(...Object.entries(this.details.answers).sort(failuresFirst).map(([method, answer]) => {
      const traced = this.traceOf(method);
      return h('button.chip', {
        type: 'button',
        class: `chip ${answer.outcome}`,
        'aria-pressed': String(method === this.method),
        disabled: !traced && answer.outcome === 'correct',
        title: traced ? 'Show its trace' : 'The contact was not traced through it',
        onclick: () => this.select(method, traced?.loss?.level ?? Math.min(this.level, traced?.levels ?? 0)),
      }, h('span.dot', { style: `background:${colourOf(method)}` }), `${method} `, h('b', answer.outcome.replace('_', ' ')));
    }));
  }

  /** The pair of cells that the chosen method's trace came to at a level. */
  cellsOf(level) {
    return this.traceOf(this.method)?.steps.find((s) => s[0] === level)?.[2] ?? this.details.cells?.[level];
  }

  /** The step of the chosen method at the chosen level, if it came so far. */
  step() {
    return this.traceOf(this.method)?.steps.find((s) => s[0] === this.level);
  }

  select(method, level) {
    this.method = method;
    this.level = level;
    this.fillChips();
    const trace = this.traceOf(method);
    const answer = this.details.answers[method];
    this.ladder.replaceChildren(...ladder(trace, this.details.traces, level, (l) => this.select(method, l)));
    this.sentence.replaceChildren(...verdict(method, answer, trace, this.centre.t));
    this.numbers.replaceChildren(numbersTable({
      known: this.case, centre: this.centre, local: this.local, tMax: this.tMax, method, answer, loss: trace?.loss,
    }));
    this.setZoom(level);
  }

  setZoom(zoom) {
    this.zoomLevel = zoom;
    this.zoom.value = zoom;
    const { patches, uv } = this.local;
    const cellOf = (s, level) => this.cellsOf(level)?.[s] ?? cellAt(patches[s].shape, uv[s], level);
    this.picture = pictureOf(this.local, this.tMax, zoom, cellOf);
    const { scale } = this.picture;
    this.range = this.picture.range;
    const toi = this.details.answers[this.method]?.toi;
    const late = typeof toi === 'number' ? toNumber(subtract(fractionOf(toi), this.centre.t)) : 0;
    this.slice.load({ picture: this.picture, local: this.local, witness: this.centre.witness, separation: this.separation, late });
    const parts = this.picture.parts.map((part, s) => {
      const boxes = [];
      for (let level = this.areBodies ? this.level + 1 : Math.min(this.level, Math.max(0, zoom - 1)); level <= this.level; ++level) {
        boxes.push({ ...cellOfPatch(patches[s], level, cellOf(s, level), uv[s]), faint: level !== this.level });
      }
      return { ...part, boxes };
    });
    const loss = this.traceOf(this.method)?.loss;
    const step = this.step();
    this.axis = loss?.level === this.level && loss.direction ? loss.direction : step?.[5] ?? null;
    const failed = loss?.level === this.level && Boolean(loss.direction);
    const drawable = this.axis?.every(Number.isFinite) && Math.max(...this.axis.map(Math.abs)) > 0;
    this.stage?.load(parts, {
      scale,
      axis: drawable ? unit(this.axis) : null,
      axisFailed: failed,
      witness: this.centre.witness,
      separation: this.separation,
      boxDt: Math.max(this.range[0], step ? step[1][0] : this.range[0]),
    });
    this.zoomText.textContent = zoom === 0 ? (this.areBodies ? 'whole bodies' : 'whole patches') : `1 : 2^${zoom}`;
    this.scaleText.textContent = `${scientific(scale, 2)} across`;
    this.track.replaceChildren(...bands({
      range: this.range, step, excluded: this.excluded(), toi: typeof toi === 'number' ? late : null, contact: this.centre.witness,
    }));
    this.fillPlots();
    const shown = this.centre.witness ? 0 : late;
    const at = Math.min(1, Math.max(0, (shown - this.range[0]) / (this.range[1] - this.range[0])));
    this.slider.value = 1000 * at;
    this.setTime(at, true);
  }

  lookAside() {
    if (!this.stage) return;
    const axis = this.stage.axis ?? this.local.normal;
    if (axis) this.stage.lookAcross(axis, 0.12);
    else this.stage.reset();
  }

  /** The magnification at which the error of the loss fills a tenth of the time shown. */
  zoomToGap() {
    const loss = this.traceOf(this.method)?.loss;
    const steps = loss?.ulps_past ?? 1;
    const error = Math.max(1, steps) * (ulpOf(this.tStar) || 2 ** -52);
    const speed = relativeSpeed(this.local.patches);
    let zoom = 0;
    for (; zoom < kDeepest; ++zoom) {
      const scale = largest(this.local.patches.flatMap((patch, s) => {
        const uv = this.local.uv[s];
        return cellOfPatch(patch, zoom + 1, cellAt(patch.shape, uv, zoom + 1), uv).controls;
      }));
      if (!(speed > 0) || (0.6 * scale) / speed < 6 * error) break;
    }
    this.setZoom(zoom);
    this.lookAside();
  }

  setTime(share, atContact = false) {
    const [lo, hi] = this.range;
    const contact = -lo / (hi - lo);
    this.dt = atContact && this.centre.witness ? 0 : lo + share * (hi - lo);
    if (Math.abs(share - contact) < 0.004 && this.centre.witness) this.dt = 0;
    this.stage?.move(this.dt);
    this.slice.move(this.dt);
    const t = this.tStar + this.dt;
    const name = this.centre.witness ? 't*' : 't_max';
    this.timeText.textContent = this.dt === 0 ? `t = ${name} = ${t}` : `t = ${name} ${this.dt < 0 ? '−' : '+'} ${scientific(Math.abs(this.dt))}`;
    this.slider.setAttribute('aria-valuetext', this.timeText.textContent);
    this.plots.style.setProperty('--now', share);
  }

  /** The level's own window and a little more, or where the eye is magnified further, what it sees. */
  plotRange() {
    const window = this.step()?.[1];
    if (!window || this.zoomLevel !== this.level || !(window[1] > window[0])) return this.range;
    const margin = 0.3 * (window[1] - window[0]);
    const most = toNumber(subtract(fractionOf(this.tMax), this.centre.t));
    return [Math.max(-this.tStar, window[0] - margin), Math.min(Math.max(most, window[1]), window[1] + margin)];
  }

  /** The times that the chosen axis excludes, from t* on. */
  excluded() {
    const loss = this.traceOf(this.method)?.loss;
    if (loss?.level === this.level && loss.excluded) {
      return loss.excluded.map((t) => toNumber(subtract(fractionOf(t), this.centre.t)));
    }
    return this.step()?.[7] ?? null;
  }

  fillPlots() {
    const trace = this.traceOf(this.method);
    const nodes = [];
    if (trace && this.axis?.every(Number.isFinite) && Math.max(...this.axis.map(Math.abs)) > 0) {
      const step = this.step();
      const cells = this.cellsOf(this.level);
      const controls = this.local.patches.map((patch, s) =>
        cellOfPatch(patch, this.level, cells[s], this.local.uv[s]).controls);
      const loss = trace.loss?.level === this.level ? trace.loss : null;
      nodes.push(heightsPlot({
        controls,
        axis: unit(this.axis),
        below: loss ? loss.below : step?.[6] ?? 0,
        range: this.plotRange(),
        excluded: this.excluded(),
        failed: Boolean(loss),
        name: loss ? loss.axis : step?.[4],
      }));
    }
    if (this.details.traces.length) nodes.push(marginPlot(this.details.traces, this.method, (level) => this.select(this.method, level)));
    this.plots.replaceChildren(...nodes);
  }

  fillButtons() {
    const command = this.details.reproduce;  // none for a line of a data set, which is no file
    this.buttons.replaceChildren(
      copyButton('Copy case (JSON)', () => JSON.stringify(this.case)),
      copyButton('Copy GoogleTest', () => this.details.gtest),
      saveButton('Save glTF', `${fileName(this.row.id)}.gltf`, () => gltfText(this.centre, this.local.origin, this.picture), 'model/gltf+json'),
      ...(command ? [copyButton('Copy command', () => command), h('code.command', command)] : []));
  }
}
