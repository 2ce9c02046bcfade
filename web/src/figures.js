// The paper's figures, of this report's data.
import * as Plot from '@observablehq/plot';
import { colourOf } from './colours.js';
import { kClasses, methods, report } from './data.js';
import { csv, durationText, h, percentText, savingHead, scientific, shortName, tableOf } from './dom.js';

const groups = report.groups ?? [];
const present = (list) => methods.filter((m) => list.some((g) => g.method === m));

/** The counts of outcomes of a group. */
export const kCounts = ['correct', 'missed', 'late', 'false_positive', 'undecided', 'unknown', 'error', 'not_asked'];

/** Groups summed up by some of their keys. */
export function summed(list, keys) {
  const counts = ['n', 'positives', 'negatives', ...kCounts];
  const found = new Map();
  for (const group of list) {
    const key = keys.map((k) => group[k]).join('\u0000');
    if (!found.has(key)) {
      const row = { seconds: null, times: [] };
      for (const k of keys) row[k] = group[k];
      for (const k of counts) row[k] = 0;
      found.set(key, row);
    }
    const row = found.get(key);
    for (const k of counts) row[k] += group[k];
    if (group.times) row.seconds = (row.seconds ?? 0) + group.mean_seconds * group.n;
    row.times.push(...(group.times ?? []));
  }
  return [...found.values()];
}

/** The answers at the contact itself, and those to negatives, as the paper asks. */
export const asInThePaper = groups.filter((g) => g.t_max_factor === null || g.t_max_factor === 1);

export const legend = (list) => h('div.legend', list.map((m) => h('span', { title: m }, h('i', { style: `background:${colourOf(m)}` }), shortName(m))));

/** A figure with buttons that save it: as a picture, and its data, a table of `rows`. */
export function figure(title, caption, rows, ...nodes) {
  const name = title.toLowerCase().replace(/[^a-z0-9]+/g, '-').replace(/-$/, '');
  const made = h('figure.card', savingHead(title, () => name, () => csv(rows), () => made), ...nodes, h('figcaption', caption));
  return made;
}

export const wide = (...parts) => {
  const made = figure(...parts);
  made.classList.add('wide');
  return made;
};

const ticks = { fx: { label: null, padding: 0.12, domain: kClasses }, x: { axis: null, padding: 0.06 } };

function bars(rows, list, options) {
  const width = Math.max(520, 60 + kClasses.length * (list.length * 15 + 14));
  return h('div.scroll', Plot.plot({
    style: { fontSize: '12px' }, width: Math.min(width, 1080), height: 250, marginLeft: 52, ...ticks,
    x: { ...ticks.x, domain: list }, ...options(rows),
  }));
}

/** Share of false negatives and positives, and mean times, per class and method (Fig. 8). */
export function fig8() {
  const rows = summed(asInThePaper, ['class', 'method']);
  const list = present(rows);
  const out = [];
  const paper = (key) => (report.paper ?? []).filter((p) => list.includes(p.method) && kClasses.includes(p.class))
    .map((p) => ({ ...p, rate: (100 * p[key][0]) / p[key][1], text: percentText(...p[key]) }));
  const rate = (title, caption, key, parts, of) => {
    const bars1 = rows.filter((r) => r[of] > 0);
    if (bars1.length === 0) return;
    const data = bars1.flatMap((r) => parts.map((part) => ({ ...r, part, rate: (100 * r[part]) / r[of] })));
    const inThePaper = (r) => (report.paper ?? []).find((p) => p.class === r.class && p.method === r.method)?.[key] ?? [];
    const saved = tableOf(['class', 'method', of, ...parts, 'paper_count', 'paper_total'],
      bars1.map((r) => ({ ...r, paper_count: inThePaper(r)[0], paper_total: inThePaper(r)[1] })));
    out.push(figure(title, caption, saved, legend(list), bars(data, list, (d) => ({
      y: { label: '↑ %', grid: true, domain: [0, Math.max(1, ...d.map((r) => (100 * parts.reduce((s, p) => s + r[p], 0)) / r[of]), ...paper(key).map((p) => p.rate)) * 1.05] },
      marks: [
        Plot.barY(d, { fx: 'class', x: 'method', y: 'rate', fill: (r) => colourOf(r.method), fillOpacity: (r) => (r.part === 'late' ? 0.45 : 0.95),
          title: (r) => `${r.method}, ${r.class}: ${r.part.replace('_', ' ')} ${r[r.part]} of ${r[of]} (${percentText(r[r.part], r[of])})` }),
        Plot.dot(paper(key), { fx: 'class', x: 'method', y: 'rate', symbol: 'diamond', r: 4, stroke: 'var(--ink)', fill: 'var(--card)', title: (p) => `the paper: ${p.method}, ${p.class}: ${p.text}` }),
        Plot.ruleY([0]),
      ],
    }))));
  };
  rate('False negatives (Fig. 8 a)', 'Share of the positive cases that a method misses or, paler, reports too late. Diamonds: what the paper’s Table 2 has of them.', 'fn', ['missed', 'late'], 'positives');
  const timed = rows.filter((r) => r.seconds > 0 && r.n > 0).map((r) => ({ ...r, mean: (1000 * r.seconds) / r.n }));
  if (timed.length > 0) {
    const least = 10 ** Math.floor(Math.log10(Math.min(...timed.map((r) => r.mean))) - 0.001);
    out.push(figure('Mean time of a query (Fig. 8 b)', 'In milliseconds, on a logarithmic scale.',
      tableOf(['class', 'method', 'n', 'mean_ms'], timed.map((r) => ({ ...r, mean_ms: r.mean }))), legend(present(timed)), bars(timed, present(timed), (d) => ({
      y: { type: 'log', label: '↑ ms', grid: true, domain: [least, Math.max(...d.map((r) => r.mean)) * 1.4], tickFormat: (v) => (Math.abs(Math.log10(v) % 1) < 1e-9 ? String(v) : '') },
      marks: [
        Plot.barY(d, { fx: 'class', x: 'method', y1: least, y2: 'mean', fill: (r) => colourOf(r.method), title: (r) => `${r.method}, ${r.class}: ${durationText(r.mean / 1000)}` }),
      ],
    }))));
  }
  rate('False positives', 'Share of the negative cases that a method calls a contact.', 'fp', ['false_positive'], 'negatives');
  return out;
}

// The report counts samples in bins of a 32nd of an octave; a quarter of an octave is drawn.
const kBinsPerOctave = 32, kFineInCoarse = 8;

/** Counts [[bin, count], …] in bins of equal width on a decimal logarithmic scale. */
function logBins(samples) {
  const width = (kFineInCoarse / kBinsPerOctave) * Math.log10(2);
  const counts = new Map();
  for (const [bin, count] of samples) {
    const place = Math.floor(bin / kFineInCoarse);
    counts.set(place, (counts.get(place) ?? 0) + count);
  }
  return [...counts].map(([place, count]) => ({ x1: place * width, x2: (place + 1) * width, count }));
}

/** The same in `bins` bins from 0 to what `share` of the samples do not exceed; the last one holds
 * those past it, too. */
function linearBins(samples, bins, share) {
  const fine = samples.map(([bin, count]) => ({ at: 2 ** ((bin + 0.5) / kBinsPerOctave), count })).sort((a, b) => a.at - b.at);
  let left = share * fine.reduce((sum, b) => sum + b.count, 0);
  const width = fine.find((b) => (left -= b.count) <= 0).at / bins;
  const counts = new Array(bins).fill(0);
  for (const b of fine) counts[Math.min(bins - 1, Math.floor(b.at / width))] += b.count;
  return counts.map((count, bin) => ({ x1: bin * width, x2: (bin + 1) * width, count })).filter((b) => b.count > 0);
}

/** Distributions of the times, linear with a logarithmic inset (Fig. 9). */
export function fig9() {
  const rows = summed(asInThePaper, ['method']).filter((r) => r.times.length > 0);
  if (rows.length === 0) return [];
  const data = [];
  const panels = rows.map((row) => {
    const linear = linearBins(row.times, 40, 0.97).map((b) => ({ ...b, x1: 1000 * b.x1, x2: 1000 * b.x2 }));
    const log = logBins(row.times);
    const add = (scale, bins, ms) => data.push(...bins.map((b) => ({ method: row.method, scale, from_ms: ms(b.x1), to_ms: ms(b.x2), count: b.count })));
    add('linear', linear, (x) => x);
    add('log', log, (x) => 1000 * 10 ** x);
    const colour = colourOf(row.method);
    const main = Plot.plot({
      style: { fontSize: '12px' }, width: 340, height: 220, marginLeft: 48,
      x: { label: 'ms →', grid: false }, y: { label: '↑ queries', grid: true },
      marks: [Plot.rectY(linear, { x1: 'x1', x2: 'x2', y: 'count', fill: colour, insetRight: 0.5 }), Plot.ruleY([0])],
    });
    const inset = Plot.plot({
      width: 190, height: 112, marginLeft: 8, marginBottom: 22, marginTop: 6, marginRight: 6,
      style: { fontSize: '9px' },
      x: { label: null, ticks: 4, tickFormat: (v) => (Number.isInteger(v) ? durationText(10 ** v).replace(' ', '\u00a0') : '') },
      y: { axis: null },
      marks: [Plot.rectY(log, { x1: 'x1', x2: 'x2', y: 'count', fill: colour, fillOpacity: 0.75, insetRight: 0.3 }), Plot.ruleY([0])],
    });
    return h('div.panel', h('h4', { title: row.method }, shortName(row.method)), h('div.with-inset', main, h('div.inset', inset)));
  });
  return [wide('Distributions of the time of a query (Fig. 9)', 'All classes together. Linear in time, up to the 97 % quantile, which the last bin goes past; the inset on a logarithmic scale.',
    tableOf(['method', 'scale', 'from_ms', 'to_ms', 'count'], data), h('div.panels', panels))];
}

/** RMS curvatures at the contacts (Fig. 5), if the report has them. */
export function fig5() {
  if (!report.curvature?.length) return [];
  const bins = logBins(report.curvature).map((b) => ({ ...b, x1: 10 ** b.x1, x2: 10 ** b.x2 }));
  const plot = Plot.plot({
    style: { fontSize: '12px' }, width: 620, height: 240, marginLeft: 52,
    x: { type: 'log', label: 'RMS curvature at the contact →', ticks: 6, tickFormat: (v) => (Math.abs(Math.log10(v) % 1) < 1e-9 ? scientific(v, 1) : '') }, y: { label: '↑ patches', grid: true },
    marks: [Plot.rectY(bins, { x1: 'x1', x2: 'x2', y: 'count', fill: 'var(--accent)' }), Plot.ruleY([0])],
  });
  return [figure('Curvature at the contact (Fig. 5)', 'Root mean square of the principal curvatures, √((κ₁² + κ₂²)/2), of each patch of a positive case at its contact.',
    tableOf(['from', 'to', 'count'], bins.map((b) => ({ from: b.x1, to: b.x2, count: b.count }))), plot)];
}
