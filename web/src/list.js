// The list of cases, by failure: each failure is its best case, until it is opened. Only the rows in sight
// are in the document, so that 5,000 are as quick as 5.
import { cases, details, isFailure, kClasses, kOutcomes, methods } from './data.js';
import { csv, h, saveButton, shortName, ulpsText } from './dom.js';
import { colourOf } from './colours.js';
import { failureGroups } from './failures.js';

const kRow = 46;

export class CaseList {
  constructor(root, onOpen) {
    this.onOpen = onOpen;
    this.chosen = -1;
    this.chosenGroup = null;
    this.expanded = new Set();
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
    this.box = h('div.list', { tabindex: 0, role: 'tree', 'aria-label': 'Cases by failure' }, this.rows);
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
    this.openFirst();
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
    this.groups = failureGroups(this.shown, (letter, method) =>
      (!outcome || letter === outcome) && (at < 0 || method === methods[at]));
    const many = this.shown.length === cases.length ? '' : ` of ${cases.length}`;
    this.count.textContent = `${this.shown.length}${many} ${this.shown.length === 1 && !many ? 'case' : 'cases'}, ${this.groups.length} ${this.groups.length === 1 ? 'group' : 'groups'}`;
    this.box.scrollTop = 0;
    this.layOut();
  }

  /** The rows that are not folded away: of each group the best, and where it is expanded, the others. */
  layOut() {
    this.entries = this.groups.flatMap((group) =>
      (this.expanded.has(group.key) ? group.members : group.members.slice(0, 1)).map((member, k) => ({ group, member, first: k === 0 })));
    this.draw();
  }

  draw() {
    const from = Math.max(0, Math.floor(this.box.scrollTop / kRow) - 4);
    const to = Math.min(this.entries.length, from + Math.ceil(this.box.clientHeight / kRow) + 8);
    this.rows.style.height = `${this.entries.length * kRow}px`;
    this.rows.replaceChildren(...this.entries.slice(from, to).map((entry, k) => this.row(entry, from + k)));
  }

  row({ group, member: { row: c, letter }, first }, place) {
    const { worst } = c;
    const lost = worst && (worst.method === group.method)
      ? `${worst.ulps === null ? '' : `${worst.ulps === 0 ? '< 1 ulp' : ulpsText(worst.ulps)} at `}level ${worst.level}` : '';
    const setting = c.setting === 'ordinary' ? '' : c.setting;
    const { length } = group.members;
    const open = this.expanded.has(group.key);
    const text = group.method ? [kOutcomes[letter], group.cause, setting, lost] : [c.failed.length ? '' : 'no failure', setting];
    return h('div.item', {
      role: 'treeitem', id: `case-${place}`, class: `item${first ? '' : ' more'}`, style: `top:${place * kRow}px`,
      'aria-selected': String(this.isChosen({ group, member: { row: c } })), 'aria-level': first ? 1 : 2,
      'aria-expanded': first && length > 1 ? String(open) : null, onclick: () => this.openEntry(place),
    },
    h('span.class-tag', c.contact || '–'),
    h('span.what', { title: group.method }, h('b', group.method ? shortName(group.method) : c.kind), h('small', text.filter(Boolean).join(' · '))),
    h('span.dots', c.failed.slice(0, 6).map((m) => h('i.dot', { style: `background:${colourOf(m)}`, title: m }))),
    c.isNew ? h('span.new', 'new') : null,
    first && length > 1 ? h('button.fold', {
      type: 'button', tabindex: -1, 'aria-label': `${open ? 'Fold' : 'Show'} all ${length}`,
      onclick: (event) => { event.stopPropagation(); this.fold(group, !open); },
    }, `${open ? '▾' : '▸'} ${length}`) : null);
  }

  fold(group, open) {
    if (open) this.expanded.add(group.key);
    else this.expanded.delete(group.key);
    this.layOut();
  }

  isChosen({ group, member }) {
    return member.row.index === this.chosen && group.key === this.chosenGroup;
  }

  openFirst() {
    if (this.entries.length > 0) this.openEntry(0);
  }

  /** Opens a case in the group where it is best. */
  open(index) {
    const places = this.groups.map(({ members }) => members.findIndex(({ row }) => row.index === index));
    const nearest = Math.min(...places.filter((k) => k >= 0));
    const group = this.groups[places.indexOf(nearest)];
    if (!group) return this.onOpen(cases[index], this.method.value);
    if (nearest > 0) this.fold(group, true);
    return this.openEntry(this.entries.findIndex((e) => e.group === group && e.member.row.index === index), true);
  }

  openEntry(place, focus = false) {
    const { group, member } = this.entries[place];
    this.chosen = member.row.index;
    this.chosenGroup = group.key;
    const top = place * kRow;
    if (top < this.box.scrollTop) this.box.scrollTop = top;
    else if (top + kRow > this.box.scrollTop + this.box.clientHeight) this.box.scrollTop = top + kRow - this.box.clientHeight;
    this.draw();
    this.box.setAttribute('aria-activedescendant', `case-${place}`);
    if (focus) this.box.focus();
    this.onOpen(member.row, this.method.value || group.method);
  }

  key(event) {
    const place = this.entries.findIndex((entry) => this.isChosen(entry));
    const page = Math.max(1, Math.floor(this.box.clientHeight / kRow) - 1);
    const { group, first } = this.entries[place] ?? {};
    if (group && (event.key === 'ArrowRight' || event.key === 'ArrowLeft')) {
      event.preventDefault();
      const open = event.key === 'ArrowRight';
      if (!open && !first) this.openEntry(this.entries.findIndex((e) => e.group === group));
      if (group.members.length > 1) this.fold(group, open);
      return;
    }
    const to = {
      ArrowDown: place + 1, ArrowUp: place - 1, PageDown: place + page, PageUp: place - page,
      Home: 0, End: this.entries.length - 1,
    }[event.key];
    if (to === undefined || this.entries.length === 0) return;
    event.preventDefault();
    this.openEntry(Math.min(this.entries.length - 1, Math.max(0, to)));
  }
}
