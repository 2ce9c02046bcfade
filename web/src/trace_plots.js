import * as Plot from '@observablehq/plot';
import { colourOf } from './colours.js';
import { csv, h, savingHead, scientific, superscript, tableOf, ulpsText } from './dom.js';

const kPatch = ['var(--patch-1)', 'var(--patch-2)'];

function figure(title, caption, rows, plot) {
  const name = () => title.toLowerCase().replaceAll(' ', '-');
  const made = h('figure.trace-plot', savingHead(title, name, () => csv(rows), () => made), plot, h('figcaption', caption));
  return made;
}

/** Heights of both parts along an axis over time, from the contact: what the method's lines are. */
export function heightsPlot({ controls, axis, below, range, excluded, failed, name }) {
  const [lo, hi] = range;
  const above = 1 - below;
  const lines = controls.map((points) => points.map(({ p, v }) => ({
    at: p.reduce((sum, x, k) => sum + x * axis[k], 0),
    slope: v.reduce((sum, x, k) => sum + x * axis[k], 0),
  })));
  // The velocity that the frame moves along with is in no line, so the heights are as seen from there.
  const kSamples = 96;
  const rows = [];
  for (let i = 0; i <= kSamples; ++i) {
    let dt = lo + (i / kSamples) * (hi - lo);
    if (lo < 0 && hi > 0 && Math.abs(dt) < (hi - lo) / (2 * kSamples)) dt = 0;
    const heights = lines.map((part) => part.map(({ at, slope }) => at + dt * slope));
    rows.push({
      dt,
      upper: Math.max(...heights[below]), lowest: Math.min(...heights[below]),
      lower: Math.min(...heights[above]), highest: Math.max(...heights[above]),
    });
  }
  const most = Math.max(...rows.flatMap((r) => [Math.abs(r.upper), Math.abs(r.lower)])) || 1;
  const unit = 10 ** Math.floor(Math.log10(most));
  const timeUnit = 10 ** Math.floor(Math.log10(Math.max(Math.abs(lo), Math.abs(hi)) || 1));
  const clip = (x) => Math.max(-1.6 * most, Math.min(1.6 * most, x)) / unit;
  const exponent = (x) => Math.round(Math.log10(x));
  const scale = (x, name) => exponent(x) === 0 ? name : `${name} / 10${superscript(exponent(x))}`;
  const band = excluded && [Math.max(lo, excluded[0]) / timeUnit, Math.min(hi, excluded[1]) / timeUnit];
  const plot = Plot.plot({
    style: { fontSize: '12px' }, width: 460, height: 240, marginLeft: 48, marginBottom: 40,
    x: { label: `${scale(timeUnit, 't − t*')} →`, domain: [lo / timeUnit, hi / timeUnit] },
    y: { label: `↑ ${scale(unit, 'height')}`, grid: true },
    marks: [
      band && band[1] > band[0] ? Plot.rect([band], { x1: (d) => d[0], x2: (d) => d[1], fill: failed ? 'var(--alarm)' : 'var(--calm)', fillOpacity: 0.14 }) : null,
      Plot.areaY(rows, { x: (d) => d.dt / timeUnit, y1: (d) => clip(d.lowest), y2: (d) => clip(d.upper), fill: kPatch[below], fillOpacity: 0.22 }),
      Plot.areaY(rows, { x: (d) => d.dt / timeUnit, y1: (d) => clip(d.lower), y2: (d) => clip(d.highest), fill: kPatch[above], fillOpacity: 0.22 }),
      Plot.lineY(rows, { x: (d) => d.dt / timeUnit, y: (d) => clip(d.upper), stroke: kPatch[below], strokeWidth: 2 }),
      Plot.lineY(rows, { x: (d) => d.dt / timeUnit, y: (d) => clip(d.lower), stroke: kPatch[above], strokeWidth: 2 }),
      lo <= 0 && hi >= 0 ? Plot.ruleX([0], { stroke: 'var(--ink)', strokeDasharray: '3,3' }) : null,
    ],
  });
  return figure('Heights along the axis', `Both boxes along axis ${name ?? ''}: upper envelope of patch ${below + 1}, lower envelope of patch ${above + 1}. Shaded: the time in which the method takes them apart.${failed ? ' The contact (dashed) is in it.' : ''}`,
    tableOf(['dt', 'upper', 'lowest', 'lower', 'highest'], rows), plot);
}

/** By how many ulps the witness survived each level, of every traced method. */
export function marginPlot(traces, chosen, onLevel) {
  const points = [];
  for (const { method, steps, loss } of traces) {
    for (const [level, , , ulps] of steps) {
      if (loss?.level === level) points.push({ method, level, ulps: 0, lost: true });
      else if (ulps !== null) points.push({ method, level, ulps, lost: false });
    }
  }
  const kept = points.filter((p) => !p.lost);
  const at = (p) => (p.ulps < 1 ? 0.4 : p.ulps);
  const plot = Plot.plot({
    style: { fontSize: '12px' }, width: 460, height: 240, marginLeft: 48, marginBottom: 40,
    x: { label: 'level →', domain: [-0.5, Math.max(14.5, ...points.map((p) => p.level + 0.5))], ticks: 8, tickFormat: 'd' },
    y: { type: 'log', label: '↑ margin in ulps', domain: [0.3, Math.max(10, ...kept.map(at)) * 2], grid: true, ticks: 5, tickFormat: (d) => (d < 1 ? '' : scientific(d, 1)) },
    marks: [
      Plot.ruleY([1], { stroke: 'var(--faint)', strokeDasharray: '2,3' }),
      Plot.lineY(points, { x: 'level', y: at, z: 'method', stroke: (p) => colourOf(p.method), strokeOpacity: (p) => (p.method === chosen ? 1 : 0.35), strokeWidth: 1.6 }),
      Plot.dot(kept, { x: 'level', y: at, fill: (p) => colourOf(p.method), fillOpacity: (p) => (p.method === chosen ? 1 : 0.4), r: 3.2, title: (p) => `${p.method}, level ${p.level}: ${ulpsText(p.ulps)}` }),
      Plot.dot(points.filter((p) => p.lost), { x: 'level', y: at, symbol: 'times', stroke: 'var(--alarm)', strokeWidth: 2.6, r: 6, title: (p) => `${p.method} loses the contact at level ${p.level}` }),
    ],
  });
  plot.addEventListener('click', (event) => {
    const x = plot.scale('x');
    const level = Math.round(x.invert ? x.invert((event.offsetX * 460) / plot.clientWidth) : NaN);
    if (Number.isFinite(level) && level >= 0) onLevel(level);
  });
  return figure('Margins by level', 'By how many ulps the contact survived each level. A cross is where it was lost; points on the floor are kept by less than an ulp.',
    tableOf(['method', 'level', 'ulps', 'lost'], points), plot);
}
