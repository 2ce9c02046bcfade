// Planted faults: how soon each driver of the tests notices them.
import * as Plot from '@observablehq/plot';
import { board } from './data.js';
import { csv, durationText, h, saveButton, tableOf } from './dom.js';
import { wide } from './figures.js';

const kColours = ['#0072b2', '#d55e00', '#009e73', '#9467bd', '#e69f00', '#cc2f7f'];
const kLeast = 1e-4;  // seconds; what is sooner stands left of it

const drivers = board?.drivers ?? [];
const names = drivers.map((d) => d.driver);
// Detected by more than half of the runs.
const rows = (board?.rows ?? []).filter((r) => r.fault !== 'none').map((r) => ({ ...r, kill: 2 * r.detected > r.runs }));
const colourOfDriver = (name) => kColours[Math.max(0, names.indexOf(name)) % kColours.length];
const timeText = (r) => (r.kill ? durationText(r.seconds) : `not in ${durationText(r.limit)}`);

/** A table whose columns are [title, text(row), isNumber]; order(row) of each for sorting. */
function table(columns, list, sorted, onSort) {
  const head = h('thead', h('tr', columns.map(({ title, order, number }, at) => {
    const direction = sorted?.at === at ? sorted.sign : 0;
    return h('th', {
      scope: 'col', class: number ? '' : 'text', 'aria-sort': direction > 0 ? 'ascending' : direction < 0 ? 'descending' : null,
    }, order && onSort ? h('button.sort', { type: 'button', onclick: () => onSort(at) }, title, direction > 0 ? ' ▲' : direction < 0 ? ' ▼' : '') : title);
  })));
  const body = h('tbody', list.map((row) => h('tr', columns.map(({ text, number, mark }, at) =>
    h(at === 0 ? 'th' : 'td', { ...(at === 0 ? { scope: 'row' } : {}), class: [number ? '' : 'text', mark?.(row) ?? ''].join(' ').trim() }, text(row))))));
  return h('table.data.faults', head, body);
}

function summary() {
  const columns = [
    { title: 'driver', text: (d) => [h('i.dot', { style: `background:${colourOfDriver(d.driver)}` }), d.driver] },
    { title: 'killed', number: true, text: (d) => `${d.killed} of ${d.faults}` },
    { title: 'reached', number: true, text: (d) => d.reached },
    { title: 'triggered', number: true, text: (d) => d.triggered },
    { title: 'median CPU time, misses counted as longest', number: true, text: (d) => `${d.censored ? '≥ ' : ''}${durationText(d.seconds)}` },
    { title: 'false alarms', number: true, text: (d) => `${d.false_alarms} of ${d.clean_runs}`, mark: (d) => (d.false_alarms > 0 ? 'bad' : '') },
  ];
  const data = () => csv(tableOf(['driver', 'faults', 'killed', 'reached', 'triggered', 'clean_runs', 'false_alarms', 'seconds', 'executions', 'mean_seconds', 'censored'], drivers));
  return h('section.card', { id: 'drivers' },
    h('div.table-head', h('h3', 'Planted faults: would the tests notice?'), saveButton('CSV', 'scoreboard-drivers.csv', data)),
    h('div.scroll', table(columns, drivers)),
    h('p.note', 'Each fault is compiled into the sources and made active alone; a driver kills it when it reports a failure within its limit of CPU time. The median is over all faults, and is “≥” where it is that of a miss. Reached: the faulty line ran; triggered: it computed something else than the right one. False alarms: failures on the right sources.'));
}

/** One dot a fault and driver, on a logarithmic scale of CPU time. */
function dots() {
  const asked = rows.filter((r) => !r.equivalent);
  // Side by side over a range of places, where there is no time to tell them apart by.
  const spread = (from, to, wanted) => names.flatMap((name) => {
    const all = asked.filter((r) => r.driver === name && wanted(r));
    return all.map((r, i) => ({ ...r, x: (r.kill ? 1 : r.limit) * from * (to / from) ** ((i + 0.5) / all.length) }));
  });
  const kills = [...asked.filter((r) => r.kill && r.seconds >= kLeast).map((r) => ({ ...r, x: r.seconds })),
    ...spread(0.4 * kLeast, 0.9 * kLeast, (r) => r.kill && r.seconds < kLeast)];
  const left = spread(1.2, 2.3, (r) => !r.kill);
  const limits = names.map((name) => ({ driver: name, limit: Math.max(...asked.filter((r) => r.driver === name).map((r) => r.limit)) }));
  const title = (r) => `${r.fault}: ${r.what}\n${r.driver}: ${timeText(r)}${r.found ? `\nby ${r.found}` : ''}`;
  const most = Math.max(1, ...limits.map((l) => l.limit)) * 2.6;
  const ticks = [];
  for (let t = kLeast; t < most; t *= 10) ticks.push(Number(t.toPrecision(1)));
  const plot = Plot.plot({
    style: { fontSize: '12px' }, width: 980, height: 40 + 92 * names.length, marginLeft: 100, marginRight: 24,
    fy: { domain: names, label: null, padding: 0.06 },
    x: { type: 'log', domain: [kLeast * 0.3, Math.max(most, ...kills.map((r) => r.x * 1.3))], label: 'CPU time to a kill →', grid: true, ticks, tickFormat: durationText },
    marks: [
      Plot.ruleX(limits, { x: 'limit', fy: 'driver', stroke: 'var(--faint)', strokeDasharray: '3,3' }),
      Plot.dot(kills, Plot.dodgeY({ anchor: 'middle', padding: 0.4 }, { x: 'x', fy: 'driver', r: 2.8, fill: (r) => colourOfDriver(r.driver), fillOpacity: 0.85, title })),
      Plot.dot(left, Plot.dodgeY({ anchor: 'middle', padding: 0.4 }, { x: 'x', fy: 'driver', r: 2.8, symbol: 'times', stroke: 'var(--alarm)', strokeWidth: 1.6, title })),
    ],
  });
  return wide('CPU time to a kill, fault by fault', 'One dot a fault, on a logarithmic scale; dots left of 100 µs were killed at once. Red crosses, right of the dashed limit of their driver, were not killed within it. Faults that change nothing noticeable are left out.',
    tableOf(['driver', 'fault', 'what', 'equivalent', 'runs', 'reached', 'triggered', 'detected', 'kill', 'seconds', 'executions', 'limit', 'found'], rows), h('div.scroll', plot));
}

function faults() {
  const byFault = new Map();
  for (const row of rows) {
    if (!byFault.has(row.fault)) byFault.set(row.fault, { fault: row.fault, what: row.what, equivalent: row.equivalent, place: byFault.size, by: {} });
    byFault.get(row.fault).by[row.driver] = row;
  }
  const all = [...byFault.values()];
  const killed = (f, name) => Boolean(f.by[name]?.kill);
  const columns = [
    { title: 'fault', text: (f) => f.fault, order: (f) => f.fault },
    { title: 'what', text: (f) => [f.what, f.equivalent ? h('span.faint', ' (equivalent)') : ''], order: (f) => f.what },
    ...names.map((name) => ({
      title: name, number: true, text: (f) => (f.by[name] ? timeText(f.by[name]) : ''),
      mark: (f) => (f.by[name] && !f.by[name].kill && !f.equivalent ? 'bad' : ''),
      order: (f) => (!f.by[name] ? Infinity : f.by[name].kill ? f.by[name].seconds : 1e9),
    })),
  ];
  const search = h('input', { type: 'search', placeholder: 'fault', 'aria-label': 'Fault holds' });
  const choice = h('select', { 'aria-label': 'Killed or not' }, [
    ['', 'all faults'], ['none', 'killed by no driver'], ['equivalent', 'equivalent'],
    ...names.flatMap((n) => [[`+${n}`, `killed by ${n}`], [`-${n}`, `not killed by ${n}`]]),
  ].map(([value, text]) => h('option', { value }, text)));
  const count = h('div.count', { 'aria-live': 'polite' });
  const box = h('div.scroll.fault-rows', { tabindex: 0, role: 'region', 'aria-label': 'Faults' });
  let sorted = null;
  const wanted = (f) => {
    const { value } = choice;
    if (value === 'equivalent') return f.equivalent;
    if (value === 'none') return !f.equivalent && names.every((n) => !killed(f, n));
    if (value.startsWith('+')) return killed(f, value.slice(1));
    if (value.startsWith('-')) return !f.equivalent && f.by[value.slice(1)] && !killed(f, value.slice(1));
    return true;
  };
  const draw = () => {
    const text = search.value.trim().toLowerCase();
    const list = all.filter((f) => wanted(f) && (!text || `${f.fault} ${f.what}`.toLowerCase().includes(text)));
    if (sorted) {
      const { order } = columns[sorted.at];
      const compare = (a, b) => (a < b ? -1 : a > b ? 1 : 0);
      list.sort((a, b) => sorted.sign * compare(order(a), order(b)) || a.place - b.place);
    }
    count.textContent = list.length === all.length ? `${all.length} faults` : `${list.length} of ${all.length} faults`;
    const focused = document.activeElement?.closest?.('.fault-rows th')?.cellIndex;
    box.replaceChildren(table(columns, list, sorted, (at) => {
      sorted = sorted?.at === at ? { at, sign: -sorted.sign } : { at, sign: 1 };
      draw();
    }));
    if (focused >= 0) box.querySelectorAll('thead th')[focused].querySelector('button')?.focus();
  };
  search.addEventListener('input', draw);
  choice.addEventListener('change', draw);
  draw();
  const data = () => csv([['fault', 'what', 'equivalent', ...names.flatMap((n) => [`${n} killed`, `${n} seconds`])],
    ...all.map((f) => [f.fault, f.what, f.equivalent ? 1 : 0, ...names.flatMap((n) => (f.by[n] ? [f.by[n].kill ? 1 : 0, f.by[n].seconds] : ['', '']))])]);
  return h('section.card', { id: 'faults' },
    h('div.table-head', h('h3', 'All faults'), saveButton('CSV', 'faults.csv', data)),
    h('div.filters.in-row', choice, search), count, box);
}

export function scoreboard() {
  return [summary(), dots(), faults()];
}
