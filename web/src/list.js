// The list of cases: only the rows in sight are in the document, so that 5,000 are as quick as 5.
import { cases, details, isFailure, kClasses, kOutcomes, methods } from './data.js';
import { csv, h, saveButton, ulpsText } from './dom.js';
import { colourOf } from './colours.js';

const kRow = 46;

export class CaseList {
  constructor(root, onOpen) {
    this.onOpen = onOpen;
    this.chosen = -1;
    this.shown = cases;
    const select = (label, options) => h('select', { 'aria-label': label }, options.map(([value, text]) => h('option', { value }, text)));
    this.method = select('Method', [['', 'any method'], ...methods.map((m) => [m, m])]);
    this.contact = select('Class', [['', 'any class'], ...kClasses.map((c) => [c, c || '–'])]);
    this.outcome = select('Outcome', [['', 'any outcome'], ...['m', 'l', 'f', 'e', 'u', 'c'].map((c) => [c, kOutcomes[c]])]);
    this.age = select('New or known', [['', 'new and known'], ['new', 'new'], ['known', 'known']]);
    if (cases.every((c) => c.isNew === null)) this.age.hidden = true;
    this.search = h('input', { type: 'search', placeholder: 'name', 'aria-label': 'Name holds' });
    this.count = h('div.count', { 'aria-live': 'polite' });
    this.rows = h('div.rows');
    this.box = h('div.list', { tabindex: 0, role: 'listbox', 'aria-label': 'Cases' }, this.rows);
    root.append(h('div.filters', this.method, this.contact, this.outcome, this.age, this.search),
      h('div.table-head', this.count, saveButton('CSV', 'cases.csv', () => this.table())), this.box);
    for (const one of [this.method, this.contact, this.outcome, this.age]) one.addEventListener('change', () => this.filter());
    this.search.addEventListener('input', () => this.filter());
    this.box.addEventListener('scroll', () => this.draw());
    this.box.addEventListener('keydown', (event) => this.key(event));
    new ResizeObserver(() => this.draw()).observe(this.box);
    this.filter();
  }

  /** The answers to the cases shown, as CSV. */
  async table() {
    const rows = [['case', 'class', 'kind', 'generator', 'method', 'outcome', 'toi']];
    for (const c of this.shown) {
      const { answers } = await details(c.index);
      for (const [method, { outcome, toi }] of Object.entries(answers)) rows.push([c.id, c.contact, c.kind, c.generator, method, outcome, toi]);
    }
    return csv(rows);
  }

  pick(method, contact) {
    this.method.value = method;
    this.contact.value = contact;
    this.outcome.value = '';
    this.search.value = '';
    this.filter();
    if (this.shown.length > 0) this.open(this.shown[0].index);
  }

  filter() {
    const at = methods.indexOf(this.method.value);
    const { value: outcome } = this.outcome;
    const letters = (c) => (at < 0 ? [...c.outcomes] : [c.outcomes[at]]);
    const wanted = (l) => (outcome ? l === outcome : at < 0 || isFailure(l));
    const text = this.search.value.trim().toLowerCase();
    this.shown = cases.filter((c) =>
      (!this.contact.value || c.contact === this.contact.value) &&
      letters(c).some(wanted) &&
      (!this.age.value || c.isNew === (this.age.value === 'new')) &&
      (!text || `${c.id} ${c.generator} ${c.kind}`.toLowerCase().includes(text)));
    this.count.textContent = this.shown.length === cases.length ? `${cases.length} cases` : `${this.shown.length} of ${cases.length} cases`;
    this.box.scrollTop = 0;
    this.draw();
  }

  draw() {
    const from = Math.max(0, Math.floor(this.box.scrollTop / kRow) - 4);
    const to = Math.min(this.shown.length, from + Math.ceil(this.box.clientHeight / kRow) + 8);
    this.rows.style.height = `${this.shown.length * kRow}px`;
    this.rows.replaceChildren(...this.shown.slice(from, to).map((c, k) => this.row(c, from + k)));
  }

  row(c, place) {
    const { worst } = c;
    const what = worst
      ? `lost at level ${worst.level}${worst.ulps === null ? '' : `, by ${worst.ulps === 0 ? '< 1 ulp' : ulpsText(worst.ulps)}`}`
      : c.failed.length ? '' : 'no failure';
    return h('div.item', {
      role: 'option', id: `case-${c.index}`, 'aria-selected': String(c.index === this.chosen),
      style: `top:${place * kRow}px`, onclick: () => this.open(c.index),
    },
    h('span.class-tag', c.contact || '–'),
    h('span.what', h('b', c.failed[0] ?? c.kind), c.failed.length > 1 ? ` +${c.failed.length - 1}` : '', h('small', [c.kind, what].filter(Boolean).join(' · '))),
    h('span.dots', c.failed.slice(0, 6).map((m) => h('i.dot', { style: `background:${colourOf(m)}`, title: m }))),
    c.isNew ? h('span.new', 'new') : null);
  }

  open(index, focus = false) {
    this.chosen = index;
    const place = this.shown.findIndex((c) => c.index === index);
    if (place >= 0) {
      const top = place * kRow;
      if (top < this.box.scrollTop) this.box.scrollTop = top;
      else if (top + kRow > this.box.scrollTop + this.box.clientHeight) this.box.scrollTop = top + kRow - this.box.clientHeight;
    }
    this.draw();
    this.box.setAttribute('aria-activedescendant', `case-${index}`);
    if (focus) this.box.focus();
    this.onOpen(cases[index], this.method.value);
  }

  key(event) {
    const place = this.shown.findIndex((c) => c.index === this.chosen);
    const page = Math.max(1, Math.floor(this.box.clientHeight / kRow) - 1);
    const to = {
      ArrowDown: place + 1, ArrowUp: place - 1, PageDown: place + page, PageUp: place - page,
      Home: 0, End: this.shown.length - 1,
    }[event.key];
    if (to === undefined || this.shown.length === 0) return;
    event.preventDefault();
    this.open(this.shown[Math.min(this.shown.length - 1, Math.max(0, to))].index);
  }
}
