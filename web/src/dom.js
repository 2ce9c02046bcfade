import { pngOf } from './png.js';

/** An element: h('p.note', {title: 'x'}, 'text', child, …). */
export function h(selector, ...rest) {
  const [tag, ...classes] = selector.split('.');
  const element = document.createElement(tag || 'div');
  if (classes.length) element.className = classes.join(' ');
  if (rest.length && rest[0]?.constructor === Object) {
    for (const [key, value] of Object.entries(rest.shift())) {
      if (key.startsWith('on')) element.addEventListener(key.slice(2), value);
      else if (value !== null && value !== false && value !== undefined) element.setAttribute(key, value === true ? '' : value);
    }
  }
  element.append(...rest.flat(2).filter((c) => c !== null && c !== undefined && c !== false));
  return element;
}

const kSuperscripts = '⁰¹²³⁴⁵⁶⁷⁸⁹';
export const superscript = (e) => [...String(e)].map((c) => (c === '-' ? '⁻' : kSuperscripts[c])).join('');
/** 1.2e-15 as 1.2 × 10⁻¹⁵. */
export function scientific(x, digits = 3) {
  if (x === 0) return '0';
  if (!Number.isFinite(x)) return String(x);
  const plain = Math.abs(x) >= 1e-3 && Math.abs(x) < 1e5;
  if (plain) return String(Number(x.toPrecision(digits)));
  const [m, e] = x.toExponential(digits - 1).split('e');
  const power = superscript(Number(e));
  return Number(m) === 1 && digits === 1 ? `10${power}` : `${Number(m)} × 10${power}`;
}

/** A number of ulps: 1 ulp, 3 ulps, 0.25 ulp, 4.5 × 10¹⁵ ulps. */
export function ulpsText(n) {
  return `${Number.isInteger(n) && n < 1e5 ? n : scientific(n)} ${n > 1 ? 'ulps' : 'ulp'}`;
}

export function durationText(seconds) {
  if (!(seconds > 0)) return '0 s';
  for (const [size, unit] of [[1, 's'], [1e-3, 'ms'], [1e-6, 'µs'], [1e-9, 'ns']]) {
    if (seconds >= size * 0.9995) return `${Number((seconds / size).toPrecision(3))} ${unit}`;
  }
  return `${Number((seconds / 1e-9).toPrecision(3))} ns`;
}

export function percentText(count, total) {
  if (!total) return '–';
  if (count === 0) return '0 %';
  const percent = (100 * count) / total;
  return `${percent >= 10 ? percent.toFixed(0) : percent >= 1 ? percent.toFixed(1) : percent.toPrecision(1)} %`;
}

/** A button that puts text() on the clipboard and says so. */
export function copyButton(label, text) {
  const button = h('button.copy', { type: 'button' }, label);
  button.addEventListener('click', async () => {
    const value = await text();
    let done = true;
    try {
      await navigator.clipboard.writeText(value);
    } catch {
      // Pages from disk may have no clipboard of the modern kind.
      const area = h('textarea', { 'aria-hidden': 'true', style: 'position:fixed;opacity:0' });
      area.value = value;
      document.body.append(area);
      area.select();
      done = document.execCommand('copy');
      area.remove();
    }
    button.textContent = done ? 'Copied' : 'Could not copy';
    button.dataset.copied = done ? value : '';
    setTimeout(() => (button.textContent = label), 1500);
  });
  return button;
}

/** "corpus/a.json" → "a", "b.jsonl.zst:12" → "b-12": where a case is, as the name of a file. */
export const fileName = (id) => id.replace(/^.*\//, '').replace(/\.jsonl?(\.zst)?(:|$)/, '$2').replace(/[^\w.-]+/g, '-');

/** A method's spec, of a plug-in the name of its file alone: "plugin-exec:/a/b.py" → "b.py". */
export const shortName = (method) => (method.startsWith('plugin') ? method.replace(/^[^:]*:(.*\/)?(?=.)/, '') : method);

/** A button that saves content(), text or bytes or a promise of them, as a file. name: text or a function. */
export function saveButton(label, name, content, type = 'text/csv') {
  return h('button.copy', {
    type: 'button',
    onclick: async () => {
      const link = h('a', { href: URL.createObjectURL(new Blob([await content()], { type })), download: typeof name === 'function' ? name() : name });
      link.click();
      setTimeout(() => URL.revokeObjectURL(link.href), 1000);
    },
  }, label);
}

/** A heading with buttons that save what is under it: its data as CSV, element() as PNG. name(): of the files. */
export const savingHead = (title, name, data, element) => h('div.table-head', h('h3', title), h('div.saves',
  saveButton('CSV', () => `${name()}.csv`, data),
  saveButton('PNG', () => `${name()}.png`, () => pngOf(element()), 'image/png')));

const csvField = (x) => (/[",\r\n]/.test(x) ? `"${String(x).replaceAll('"', '""')}"` : String(x ?? ''));
/** Rows of objects with a first row of their keys, for csv(). */
export const tableOf = (keys, objects) => [keys, ...objects.map((o) => keys.map((k) => o[k]))];
export const csv = (rows) => rows.map((row) => row.map(csvField).join(',') + '\n').join('');
