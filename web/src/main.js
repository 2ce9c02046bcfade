import './style.css';
import { board, cases, report } from './data.js';
import { h } from './dom.js';
import { CaseList } from './list.js';
import { fig5, fig8, fig9 } from './figures.js';
import { huntFigures } from './hunt.js';
import { overview } from './overview.js';
import { scoreboard } from './scoreboard.js';
import { allTables } from './tables.js';
import { Viewer } from './viewer.js';

document.title = `ccdfuzz: ${report.title}`;
document.getElementById('title').textContent = report.title;

const pages = new Map();
const tablist = document.getElementById('tabs');
const main = document.getElementById('main');

let list = null;
let viewer = null;

function fillCases(panel) {
  const side = h('div.side');
  const stage = h('div.case', { id: 'case' });
  panel.append(h('div.cases', side, stage));
  viewer = new Viewer(stage);
  list = new CaseList(side, (row, method) => {
    history.replaceState(null, '', `#case=${row.index}`);
    viewer.open(row, method);
  });
}

function openCase(index) {
  show('cases');
  list.open(index);
}

function pick(method, contact) {
  show('cases');
  list.pick(method, contact);
}

const definitions = [
  ['overview', 'Overview', true, (panel) => panel.append(...overview(openCase, pick))],
  ['cases', 'Counterexamples', cases.length > 0, fillCases],
  ['figures', 'Figures', report.groups?.length > 0, (panel) => panel.append(h('div.figures', ...fig8(), ...fig5(), ...fig9()))],
  ['tables', 'Tables', report.groups?.length > 0 || report.tables?.length > 0, (panel) => panel.append(...allTables())],
  ['hunt', 'Hunt', report.course?.samples.length > 1, (panel) => panel.append(h('div.figures', ...huntFigures()))],
  ['scoreboard', 'Planted faults', board, (panel) => panel.append(...scoreboard())],
];
if (!cases.some((c) => c.failed.length)) definitions[1][1] = 'Cases';

for (const [id, name, has, fill] of definitions) {
  if (!has) continue;
  const tab = h('button', {
    type: 'button', role: 'tab', id: `tab-${id}`, 'aria-controls': `panel-${id}`, 'aria-selected': 'false', tabindex: -1,
    onclick: () => show(id),
  }, name, id === 'cases' ? h('span.badge', cases.length.toLocaleString('en')) : null);
  const panel = h('section', { role: 'tabpanel', id: `panel-${id}`, 'aria-labelledby': `tab-${id}`, hidden: true });
  tablist.append(tab);
  main.append(panel);
  pages.set(id, { tab, panel, fill, filled: false });
}

function show(id) {
  for (const [name, page] of pages) {
    const on = name === id;
    page.tab.setAttribute('aria-selected', String(on));
    page.tab.tabIndex = on ? 0 : -1;
    page.panel.hidden = !on;
    if (on && !page.filled) {
      page.filled = true;
      page.fill(page.panel);
    }
  }
  if (id === 'cases' && list.chosen < 0) list.openFirst();
  if (id !== 'cases') history.replaceState(null, '', `#${id}`);
}

tablist.addEventListener('keydown', (event) => {
  const names = [...pages.keys()];
  const at = names.findIndex((name) => pages.get(name).tab === document.activeElement);
  const to = { ArrowRight: at + 1, ArrowLeft: at - 1, Home: 0, End: names.length - 1 }[event.key];
  if (to === undefined) return;
  event.preventDefault();
  const name = names[(to + names.length) % names.length];
  show(name);
  pages.get(name).tab.focus();
});

const theme = document.getElementById('theme');
theme.addEventListener('click', () => {
  const dark = getComputedStyle(document.documentElement).colorScheme === 'dark';
  document.documentElement.dataset.theme = dark ? 'light' : 'dark';
  document.dispatchEvent(new Event('ccdfuzz:theme'));
});

const hash = decodeURIComponent(location.hash.slice(1));
const wanted = /^case=(\d+)$/.exec(hash);
if (wanted && cases[Number(wanted[1])]) openCase(Number(wanted[1]));
else show(pages.has(hash) ? hash : 'overview');
document.documentElement.dataset.ready = 'true';
