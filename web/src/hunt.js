// How a hunt went: its throughput, what it found, and how nearly methods lost contacts.
import * as Plot from '@observablehq/plot';
import { colourOf } from './colours.js';
import { report } from './data.js';
import { scientific, tableOf, ulpsText } from './dom.js';
import { figure, legend } from './figures.js';

const kBins = 60;
const kSize = { style: { fontSize: '12px' }, width: 560, height: 220, marginLeft: 60 };

/** What a counter that only grows had come to at a time, between samples linearly. */
function at(samples, key, seconds) {
  const next = samples.findIndex((s) => s.seconds >= seconds);
  if (next < 0) return samples.at(-1)[key];
  const b = samples[next];
  const a = next > 0 ? samples[next - 1] : { seconds: 0, [key]: 0 };
  if (!(b.seconds > a.seconds)) return b[key];
  return a[key] + ((b[key] - a[key]) * (seconds - a.seconds)) / (b.seconds - a.seconds);
}

/** Its growth a second, in bins of the same width. */
function rates(samples, key) {
  const bins = Math.min(kBins, samples.length);
  const width = samples.at(-1).seconds / bins;
  return Array.from({ length: bins }, (_, i) => ({
    x1: i * width, x2: (i + 1) * width,
    rate: (at(samples, key, (i + 1) * width) - at(samples, key, i * width)) / width,
  }));
}

export function huntFigures() {
  const { methods, samples: rows } = report.course;
  const samples = rows.map(([seconds, queries, mutants, finds, margins]) => ({ seconds, queries, mutants, finds, margins }));
  const x = { label: 'seconds →', domain: [0, samples.at(-1).seconds] };
  const throughput = (key, unit, fill) => Plot.plot({
    ...kSize, x, y: { label: `↑ ${unit} a second`, grid: true, zero: true },
    marks: [Plot.rectY(rates(samples, key), { x1: 'x1', x2: 'x2', y: 'rate', fill, fillOpacity: 0.75, insetRight: 0.5 }), Plot.ruleY([0])],
  });
  const finds = Plot.plot({
    ...kSize, x, y: { label: '↑ counterexamples', grid: true, zero: true },
    marks: [
      Plot.areaY(samples, { x: 'seconds', y: 'finds', fill: 'var(--alarm)', fillOpacity: 0.12, curve: 'step-after' }),
      Plot.lineY(samples, { x: 'seconds', y: 'finds', stroke: 'var(--alarm)', strokeWidth: 2, curve: 'step-after' }), Plot.ruleY([0])],
  });
  const course = tableOf(['seconds', 'queries', 'mutants', 'finds', ...methods.map((m) => `margin_ulps ${m}`)],
    samples.map((s) => ({ ...s, ...Object.fromEntries(methods.map((m, at) => [`margin_ulps ${m}`, s.margins[at]])) })));
  const out = [
    figure('Queries', 'Answered and judged, a second. Classes and methods take turns, and some are slow.', course, throughput('queries', 'queries', 'var(--accent)')),
    figure('Mutants', 'Bred of the draws towards what each method nearly loses, and traced, a second.', course, throughput('mutants', 'mutants', 'var(--patch-2)')),
    figure('Counterexamples', 'How many stand in the store by this hunt’s doing: a smaller one takes the place of a larger.', course, finds),
  ];
  // On a logarithmic scale, kept by less than an ulp is drawn on the floor.
  const kFloor = 0.4;
  const floor = (m) => kFloor * 1.09 ** (methods.length - m - 1);
  const margins = methods.flatMap((method, m) => samples.filter((s) => s.margins[m] !== null)
    .map((s) => ({ method, seconds: s.seconds, ulps: s.margins[m], y: s.margins[m] === 0 ? floor(m) : s.margins[m] })));
  if (margins.length > 0) {
    const last = methods.map((m) => margins.findLast((p) => p.method === m)).filter(Boolean);
    const of = last.map((p) => p.method);
    out.push(figure('Smallest margins', 'The least number of ulps of the time by which any traced contact survived a method’s tests so far, on a logarithmic scale; those on the floor are kept by less than an ulp. Contacts that were lost do not count here.',
      course, legend(of), Plot.plot({
        ...kSize, x,
        y: { type: 'log', label: '↑ ulps', domain: [kFloor * 0.75, Math.max(10, ...margins.map((p) => p.y)) * 1.5], grid: true, ticks: 5, tickFormat: (d) => (d < 1 ? '' : scientific(d, 1)) },
        marks: [
          Plot.ruleY([1], { stroke: 'var(--faint)', strokeDasharray: '2,3' }),
          Plot.lineY(margins, { x: 'seconds', y: 'y', z: 'method', stroke: (p) => colourOf(p.method), strokeWidth: 1.8, curve: 'step-after' }),
          Plot.dot(last, { x: 'seconds', y: 'y', fill: (p) => colourOf(p.method), r: 3.5, title: (p) => `${p.method}: ${p.ulps === 0 ? 'less than an ulp' : ulpsText(p.ulps)}` }),
        ],
      })));
  }
  return out;
}
