// The paper's tables, of this report's data.
import { kClasses, methods, report } from './data.js';
import { csv, h, saveButton } from './dom.js';
import { asInThePaper, kCounts, summed } from './figures.js';

const kNames = { FF: 'Face-Face', EF: 'Edge-Face', EE: 'Edge-Edge', VF: 'Vert-Face', VE: 'Vert-Edge', VV: 'Vert-Vert' };

const milliseconds = (row) => {
  if (row?.seconds === null || row?.seconds === undefined || !row.n) return '–';
  const ms = (1000 * row.seconds) / row.n;
  return ms >= 100 ? ms.toFixed(1) : ms >= 0.995 ? ms.toFixed(2) : ms.toPrecision(2);
};
const share = (count, total) => (total ? `${count}/${total}` : '–');

function card(id, title, note, head, body, rows) {
  return h('section.card.table-card', { id },
    h('div.table-head', h('h3', title), saveButton('CSV', `${id}.csv`, () => csv(rows))),
    h('div.scroll', h('table.data', head, body)), note && h('p.note', note));
}

/** Scenario × (t, FP, FN) × methods, as Tables 1 and 2 are laid out. */
function performance(id, title, note, list, rowsOf) {
  const timed = list.some((g) => g.seconds !== null);
  const columns = methods.filter((m) => list.some((g) => g.method === m));
  const isBound = (r) => r?.undecided > 0;
  const blocks = [...(timed ? [['t (ms)', milliseconds, () => false, isBound]] : []),
    ['FP', (r) => share(r?.false_positive, r?.negatives), (r) => r?.false_positive > 0],
    ['FN missed', (r) => share(r?.missed, r?.positives), (r) => r?.missed > 0],
    ['FN late', (r) => share(r?.late, r?.positives), (r) => r?.late > 0]];
  const head = h('thead',
    h('tr', h('th', { rowspan: 2, scope: 'col' }, 'Scenario'), blocks.map(([name]) => h('th.block', { colspan: columns.length, scope: 'colgroup' }, name))),
    h('tr', blocks.map(() => columns.map((m, at) => h(at === 0 ? 'th.block' : 'th', { scope: 'col' }, m)))));
  const data = [['scenario', ...blocks.flatMap(([name]) => columns.map((m) => `${name} ${m}`))]];
  const body = h('tbody', rowsOf.map(({ name, pick }) => {
    const found = columns.map((m) => pick(m));
    data.push([name, ...blocks.flatMap(([, text]) => found.map(text))]);
    return h('tr', h('th', { scope: 'row' }, name), blocks.map(([, text, bad, marks]) => found.map((r, at) =>
      h(`td${at === 0 ? '.block' : ''}${bad(r) ? '.bad' : ''}`, marks?.(r) ? `≥ ${text(r)}` : text(r)))));
  }));
  const bounds = timed && list.some(isBound) && '≥: some of these queries ended undecided, and would take longer.';
  return card(id, title, [note, bounds].filter(Boolean).join(' ') || null, head, body, data);
}

function plain({ id, title, note, columns, rows }) {
  const head = h('thead', h('tr', columns.map((c) => h('th', { scope: 'col' }, c))));
  const body = h('tbody', rows.map((row) => h('tr', row.map((x, at) => h(at === 0 ? 'th' : 'td', at === 0 ? { scope: 'row' } : {}, x)))));
  return card(id, title, note || null, head, body, [columns, ...rows]);
}

/** What everything above is summed up from. */
function everyGroup() {
  const timed = report.groups.some((g) => g.times);
  const columns = ['class', 'kinds', 't_max_factor', 'method', 'n', 'positives', 'negatives', ...kCounts,
    ...(timed ? ['mean_seconds', 'median_seconds', 'p99_seconds'] : [])];
  return { id: 'groups', title: 'Answers by class, kind, multiple of the contact’s time and method', columns,
    rows: report.groups.map((g) => columns.map((c) => g[c])) };
}

export function allTables() {
  const out = [];
  if (asInThePaper.length > 0) {
    const byClass = summed(asInThePaper, ['class', 'method']);
    out.push(performance('table-1', 'Table 1. All cases, by class',
      'Mean time of a query; false positives of the negative cases; false negatives, missed and late, of the positive ones.',
      byClass, kClasses.map((c) => ({ name: kNames[c] ?? c, pick: (m) => byClass.find((r) => r.class === c && r.method === m) }))));
    const halves = [['RP+RN', ['RP', 'RN']], ['NHP+NMN', ['NHP', 'NMN']]];
    const rows = halves.flatMap(([name, kinds]) => {
      const half = summed(asInThePaper.filter((g) => kinds.includes(g.kinds)), ['class', 'method']);
      return kClasses.filter((c) => half.some((r) => r.class === c)).map((c) => ({ name: `${c} (${name})`, pick: (m) => half.find((r) => r.class === c && r.method === m) }));
    });
    if (rows.length > 0) out.push(performance('table-2', 'Table 2. Regular and near-hit cases apart', null, byClass, rows));
  }
  const factors = [...new Set((report.groups ?? []).map((g) => g.t_max_factor))].filter((f) => f !== null && f !== 1);
  for (const factor of factors) {
    const list = summed(report.groups.filter((g) => g.t_max_factor === factor), ['class', 'method']);
    out.push(performance(`horizon-${factor}`, `Asked up to ${factor} times the contact`, 'Past the contact, answers that are late show.',
      list, kClasses.map((c) => ({ name: kNames[c] ?? c, pick: (m) => list.find((r) => r.class === c && r.method === m) }))));
  }
  for (const table of report.tables ?? []) out.push(plain(table));
  if (report.groups?.length > 0) out.push(plain(everyGroup()));
  return out;
}
