// What this report comes to: how often each method fails in each class.
import { cases, isFailure, kClasses, kOutcomes, methods, report } from './data.js';
import { csv, h, saveButton, shortName, ulpsText } from './dom.js';
import { asInThePaper, summed } from './figures.js';
import { colourOf } from './colours.js';
import { failureGroups } from './failures.js';

const plural = (n, one) => `${n.toLocaleString('en')} ${one}${n === 1 ? '' : 's'}`;

/** failed, of how many: counts of answers where there are any, else of the cases in the page. */
function cell(method, contact, sums) {
  if (sums.length > 0) {
    const row = sums.find((r) => r.method === method && r.class === contact);
    if (!row) return null;
    if (row.n === 0 && row.not_asked > 0) return { refused: row.not_asked };
    return { missed: row.missed, late: row.late, fp: row.false_positive, error: row.error, undecided: row.undecided, of: row.positives, negatives: row.negatives };
  }
  const at = methods.indexOf(method);
  const asked = cases.filter((c) => c.contact === contact && c.outcomes[at] !== '-');
  if (asked.length === 0) return null;
  const count = (letter) => asked.filter((c) => c.outcomes[at] === letter).length;
  return { missed: count('m'), late: count('l'), fp: count('f'), error: count('e'), undecided: count('u'), of: asked.length, negatives: asked.length };
}

function matrix(onPick) {
  const all = report.groups?.length ? summed(report.groups, ['class', 'method']) : [];
  const head = h('thead', h('tr', h('th', 'method'), kClasses.map((c) => h('th', { scope: 'col' }, c || '–'))));
  const body = h('tbody', methods.map((method) => {
    const info = report.methods.find((m) => m.spec === method);
    return h('tr',
      h('th', { scope: 'row', title: [method, info?.description].filter(Boolean).join('\n') }, h('i.dot', { style: `background:${colourOf(method)}` }), shortName(method),
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
          found.undecided > 0 ? h('span.fp', `${found.undecided} undecided`) : null,
          found.error > 0 ? h('span.fp', plural(found.error, 'error')) : null,
        ];
        const style = fn > 0 ? `--heat:${(0.1 + 0.4 * heat).toFixed(3)}` : null;
        const watchable = cases.some((c) => c.contact === contact && isFailure(c.outcomes[methods.indexOf(method)]));
        return h('td', { style, class: fn > 0 ? 'hot' : '' },
          bad > 0 && watchable ? h('button', { type: 'button', onclick: () => onPick(method, contact), title: 'Show these cases' }, parts) : parts);
      }));
  }));
  const save = () => csv([['method', 'class', 'missed', 'late', 'false_positive', 'undecided', 'error', 'of'], ...methods.flatMap((method) => kClasses.flatMap((contact) => {
    const found = cell(method, contact, all);
    return found && !found.refused ? [[method, contact, found.missed, found.late, found.fp, found.undecided, found.error, found.of]] : [];
  }))]);
  return [h('div.table-head', h('h3', 'False negatives: missed + late, by method and class'), saveButton('CSV', 'overview.csv', save)),
    h('div.scroll', h('table.matrix', head, body))];
}

const kMostFailures = 8;

/** A failure and its best example, in words. */
function failureText({ method, contact, cause, members: [{ row, letter }, ...others] }) {
  const { worst } = row;
  const wrong = worst?.method === method && worst.axis >= 0 && worst.ulps !== null
    ? `: axis ${worst.axis} is wrong by ${worst.ulps === 0 ? 'less than an ulp' : ulpsText(worst.ulps)} of the time, at level ${worst.level}` : '';
  const details = [kOutcomes[letter], contact, cause, row.setting === 'ordinary' ? '' : row.setting].filter(Boolean).join(', ');
  return [h('b', { title: method }, shortName(method)), ` ${details}${wrong}`, others.length > 0 ? h('span.of', ` and ${others.length.toLocaleString('en')} more`) : null];
}

const failuresCsv = (groups) => csv([['method', 'class', 'cause', 'cases', 'best', 'outcome', 'setting', 'significant_bits'],
  ...groups.map(({ method, contact, cause, members: [{ row, letter }, ...others] }) =>
    [method, contact, cause, 1 + others.length, row.id, kOutcomes[letter], row.setting, row.bits])]);

export function overview(open, pick) {
  const failing = cases.filter((c) => c.failed.length > 0);
  const broken = (report.methods ?? []).filter((m, at) => m.claims && cases.some((c) => 'ml'.includes(c.outcomes[at])));
  const left = report.cases_left_out ?? 0;
  const all = failing.length + left;
  const queries = (report.groups ?? []).reduce((s, g) => s + g.n, 0);
  const facts = [
    queries > 0 && [queries.toLocaleString('en'), 'answers judged'],
    [all.toLocaleString('en'), `${all === 1 ? 'counterexample' : 'counterexamples'}${left > 0 ? `, ${failing.length.toLocaleString('en')} of them here` : ''}`],
    cases.some((c) => c.isNew !== null) && [cases.filter((c) => c.isNew).length.toLocaleString('en'), 'of them new'],
    [String(broken.length), broken.length === 1 ? 'guarantee broken' : 'guarantees broken'],
  ].filter(Boolean);
  const rates = asInThePaper.length ? '' : ' Counts are of the cases in this page.';
  const groups = failureGroups(failing, () => true);
  const shown = groups.slice(0, kMostFailures);
  return [
    h('div.facts', facts.map(([n, what]) => h('div', h('b', n), h('span', what)))),
    h('section.card',
      matrix(pick),
      h('p.note', `Missed: the method says that there is no contact, and an exact witness proves one. Late: it reports a time after a proven contact. FP: it reports a contact that is proven to be none.${rates}`,
        broken.length > 0 ? ` These guarantee no false negative, and have some: ${broken.map((m) => m.spec).join(', ')}.` : '')),
    shown.length > 0 ? h('section.card', { id: 'failures' },
      h('div.table-head', h('h3', 'Failures: method, class and cause'), saveButton('CSV', 'failures.csv', () => failuresCsv(groups))),
      h('ul.telling', shown.map((group) => h('li', h('button.link', { type: 'button', onclick: () => open(group.members[0].row.index) }, failureText(group))))),
      groups.length > shown.length ? h('p.note', `The best example of each; ${groups.length - shown.length} more are under Counterexamples.`) : null) : null,
    h('p.note', 'Made by ', h('code', report.command || 'ccdfuzz'),
      report.cases_left_out ? `. ${plural(report.cases_left_out, 'further failing case')} ${report.cases_left_out === 1 ? 'has' : 'have'} no room here.` : '.'),
  ].filter(Boolean);
}
