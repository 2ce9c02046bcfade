// What this report comes to: how often each method fails in each class.
import { cases, isFailure, kClasses, methods, report } from './data.js';
import { csv, h, saveButton, ulpsText } from './dom.js';
import { asInThePaper, summed } from './figures.js';
import { colourOf } from './colours.js';

const plural = (n, one) => `${n.toLocaleString('en')} ${one}${n === 1 ? '' : 's'}`;

/** failed, of how many: counts of answers where there are any, else of the cases in the page. */
function cell(method, contact, sums) {
  if (sums.length > 0) {
    const row = sums.find((r) => r.method === method && r.class === contact);
    if (!row) return null;
    if (row.n === 0 && row.not_asked > 0) return { refused: row.not_asked };
    return { missed: row.missed, late: row.late, fp: row.false_positive, error: row.error, of: row.positives, negatives: row.negatives };
  }
  const at = methods.indexOf(method);
  const asked = cases.filter((c) => c.contact === contact && c.outcomes[at] !== '-');
  if (asked.length === 0) return null;
  const count = (letter) => asked.filter((c) => c.outcomes[at] === letter).length;
  return { missed: count('m'), late: count('l'), fp: count('f'), error: count('e'), of: asked.length, negatives: asked.length };
}

function matrix(onPick) {
  const all = report.groups?.length ? summed(report.groups, ['class', 'method']) : [];
  const head = h('thead', h('tr', h('th', 'method'), kClasses.map((c) => h('th', { scope: 'col' }, c || '–'))));
  const body = h('tbody', methods.map((method) => {
    const info = report.methods.find((m) => m.spec === method);
    return h('tr',
      h('th', { scope: 'row', title: info?.description }, h('i.dot', { style: `background:${colourOf(method)}` }), method,
        info?.claims ? h('span.claim', { title: 'guarantees no false negative' }, ' guaranteed') : null),
      kClasses.map((contact) => {
        const found = cell(method, contact, all);
        if (!found) return h('td.empty', '–');
        if (found.refused) return h('td.empty', { title: `${found.refused.toLocaleString('en')} queries` }, 'refused');
        const fn = found.missed + found.late;
        const bad = fn + found.fp + found.error;
        const heat = found.of ? Math.min(1, Math.sqrt(fn / found.of)) : 0;
        const parts = [
          h('b', fn === 0 ? '0' : found.late ? `${found.missed} + ${found.late}` : String(found.missed)),
          h('span.of', ` of ${found.of}`),
          found.fp > 0 ? h('span.fp', `${found.fp} FP`) : null,
          found.error > 0 ? h('span.fp', plural(found.error, 'error')) : null,
        ];
        const style = fn > 0 ? `--heat:${(0.12 + 0.6 * heat).toFixed(3)}` : null;
        const watchable = cases.some((c) => c.contact === contact && isFailure(c.outcomes[methods.indexOf(method)]));
        return h('td', { style, class: fn > 0 ? 'hot' : '' },
          bad > 0 && watchable ? h('button', { type: 'button', onclick: () => onPick(method, contact), title: 'Show these cases' }, parts) : parts);
      }));
  }));
  const save = () => csv([['method', 'class', 'missed', 'late', 'false_positive', 'error', 'of'], ...methods.flatMap((method) => kClasses.flatMap((contact) => {
    const found = cell(method, contact, all);
    return found && !found.refused ? [[method, contact, found.missed, found.late, found.fp, found.error, found.of]] : [];
  }))]);
  return [h('div.table-head', h('h3', 'False negatives: missed + late, by method and class'), saveButton('CSV', 'overview.csv', save)),
    h('div.scroll', h('table.matrix', head, body))];
}

export function overview(open, pick) {
  const failing = cases.filter((c) => c.failed.length > 0);
  const broken = (report.methods ?? []).filter((m, at) => m.claims && cases.some((c) => 'ml'.includes(c.outcomes[at])));
  const queries = (report.groups ?? []).reduce((s, g) => s + g.n, 0);
  const facts = [
    queries > 0 && [queries.toLocaleString('en'), 'queries judged'],
    [failing.length.toLocaleString('en'), failing.length === 1 ? 'counterexample' : 'counterexamples'],
    cases.some((c) => c.isNew !== null) && [cases.filter((c) => c.isNew).length.toLocaleString('en'), 'of them new'],
    [String(broken.length), broken.length === 1 ? 'claim broken' : 'claims broken'],
  ].filter(Boolean);
  const rates = asInThePaper.length ? '' : ' Counts are of the cases in this page.';
  // Of each method the loss that is hardest to see: the first level, the fewest ulps.
  const telling = failing.filter((c) => c.worst)
    .sort((a, b) => (a.worst.ulps ?? Infinity) - (b.worst.ulps ?? Infinity) || a.worst.level - b.worst.level);
  const seen = new Set();
  const shown = telling.filter((c) => !seen.has(c.worst.method) && seen.add(c.worst.method)).slice(0, 8);
  return [
    h('div.facts', facts.map(([n, what]) => h('div', h('b', n), h('span', what)))),
    h('section.card',
      matrix(pick),
      h('p.note', `Missed: the method says that there is no contact, and an exact witness proves one. Late: it reports a time after a proven contact. FP: it reports a contact that is proven to be none.${rates}`,
        broken.length > 0 ? ` Claimed to be free of false negatives, and are not: ${broken.map((m) => m.spec).join(', ')}.` : '')),
    shown.length > 0 ? h('section.card',
      h('h3', 'Where they were lost'),
      h('ul.telling', shown.map((c) => h('li', h('button.link', { type: 'button', onclick: () => open(c.index) },
        h('b', c.worst.method), ` lost a ${c.contact} contact at level ${c.worst.level}`,
        c.worst.axis >= 0 && c.worst.ulps !== null
          ? `: axis ${c.worst.axis} is wrong by ${c.worst.ulps === 0 ? 'less than an ulp' : ulpsText(c.worst.ulps)} of the time` : ''))))) : null,
    h('p.note', 'Made by ', h('code', report.command || 'ccdfuzz'),
      report.cases_left_out ? `. ${plural(report.cases_left_out, 'further failing case')} ${report.cases_left_out === 1 ? 'has' : 'have'} no room here.` : '.'),
  ].filter(Boolean);
}
