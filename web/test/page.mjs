// The report in a real browser: node page.mjs CCDFUZZ CORPUS WORK [SCREENSHOTS].
// Makes reports with CCDFUZZ in WORK and opens them from disk in headless Chromium. Prints a line a
// claim; exits with 1 if any does not hold. Playwright waits ten minutes, not its 30 s, for what
// does not come: slowness is no failure.
import { chromium } from 'playwright-core';
import { validateBytes } from 'gltf-validator';
import { execFileSync } from 'node:child_process';
import { copyFileSync, existsSync, mkdirSync, readFileSync, readdirSync, rmSync, statSync, writeFileSync } from 'node:fs';
import { basename, dirname, join, resolve } from 'node:path';
import { pathToFileURL } from 'node:url';
import { gunzipSync, gzipSync } from 'node:zlib';

const [ccdfuzz, corpus, work, screenshots] = process.argv.slice(2);
const kInReadme = ['case-light', 'figures'];
const kBrowser = process.env.CHROMIUM ?? ['/usr/bin/chromium', '/usr/bin/chromium-browser'].find(existsSync);

const kPatience = 600_000;  // milliseconds

let failures = 0;
function claim(what, holds, ...operands) {
  console.log(`${holds ? 'ok' : 'FAILED'}: ${what}${holds ? '' : ` (${operands.map((o) => JSON.stringify(o)).join(', ')})`}`);
  if (!holds) ++failures;
}
const run = (...args) => execFileSync(resolve(ccdfuzz), args, { cwd: dirname(resolve(corpus)), stdio: ['ignore', 'pipe', 'pipe'] });

rmSync(work, { recursive: true, force: true });
mkdirSync(work, { recursive: true });
const data = (name) => resolve(work, name);
const page = (name) => join(work, name, 'index.html');

// None, one and thousands of counterexamples; a corpus; a hunt.
run('generate', '--contact', 'VF', '--kind', 'RP', '--count', '3', '-o', data('clear.jsonl'));
run('evaluate', data('clear.jsonl'), '--methods', 'tdibm-c', '--report', data('none'));
const first = readdirSync(join(corpus, 'cases')).filter((f) => f.startsWith('tdibm-e-underflow'))[0];
mkdirSync(data('one-entry'));
copyFileSync(join(corpus, 'cases', first), join(data('one-entry'), first));
run('report', data('one-entry'), '-o', data('one'));
run('generate', '--contact', 'VV', '--kind', 'RP', '--count', '6300', '--construction', 'one-sided', '-o', data('many.jsonl'));
run('evaluate', data('many.jsonl'), '--methods', 'tdibm', '--report', data('many'));
run('report', basename(corpus), '-o', data('corpus'));
run('report', join(basename(corpus), 'engines'), '-o', data('engines'));
for (const contact of ['FF', 'EF', 'EE', 'VF', 'VE', 'VV']) {
  const count = contact === 'FF' || contact === 'EF' ? '6' : '40';
  for (const kind of ['RP', 'RN']) run('generate', '--contact', contact, '--kind', kind, '--count', count, '--construction', 'one-sided', '-o', data(`${contact}${kind}.jsonl`));
}
run('evaluate', ...['FF', 'EF', 'EE', 'VF', 'VE', 'VV'].flatMap((c) => [data(`${c}RP.jsonl`), data(`${c}RN.jsonl`)]),
  '--methods', 'tdibm,tdibm-h:1e-16,tdibm-h:1e-12,tdibm-e,tdibm-c', '--report', data('evaluation'));
run('evaluate', data('FFRP.jsonl'), '--methods', 'tdibm-c', '--max-pops', '4', '--report', data('cut'));
run('hunt', '--seconds', '3', '--shrink', 'none', '--methods', 'tdibm,tdibm-e,tdibm-c', '--max-pops', '2000', '--corpus', data('finds'), '--report', data('hunt'));
run('report', data('one-entry'), '--scoreboard', join('tests', 'report', 'scoreboard.json'), '-o', data('board'));
// A plug-in that reports each contact at t_max, and so late.
writeFileSync(data('late.mjs'), `#!${process.execPath}
import { createInterface } from 'node:readline';
for await (const line of createInterface({ input: process.stdin })) {
  const { ask, id, t_max } = JSON.parse(line);
  console.log(JSON.stringify(ask === 'describe'
    ? { protocol: 1, name: 'late', version: '1.0', conservative: false, accepts: [[{ shape: 'triangle', max_degree: 2 }, { shape: 'triangle', max_degree: 2 }]] }
    : { id, verdict: 'hit', toi: [t_max, t_max], uv: [[0, 0], [0, 0]] }));
}
`, { mode: 0o755 });
run('hunt', '--cases', '2', '--shape', 'triangle:2', '--methods', `plugin-exec:${data('late.mjs')}`, '--corpus', data('late-finds'), '--report', data('late-hunt'));
// One that reports each contact of bodies at t_max. With cases made here, and those kept of engines, all is drawn.
writeFileSync(data('late-bodies.mjs'), readFileSync(data('late.mjs'), 'utf8').replace(/accepts: .*\n/, "takes_bodies: true, accepts: [[{ shape: 'hull', max_degree: 8 }, { shape: 'hull', max_degree: 8 }]] }\n"), { mode: 0o755 });
for (const contact of ['FF', 'EF', 'EE', 'VF', 'VE', 'VV']) {
  for (const kind of ['RP', 'RN']) run('generate', '--family', 'bodies', '--contact', contact, '--kind', kind, '--count', '4', '-o', data(`bodies-${contact}${kind}.jsonl`));
}
run('evaluate', ...['FF', 'EF', 'EE', 'VF', 'VE', 'VV'].flatMap((c) => [data(`bodies-${c}RP.jsonl`), data(`bodies-${c}RN.jsonl`)]),
  '--methods', `plugin-exec:${data('late-bodies.mjs')}`, '--t-max-factors', '1,1.5', '--report', data('bodies'));
run('export', data('one-entry/' + first), '--as', 'gtest', '-o', data('one.cpp'));

/** A page of one case in place of the one in the page `one`, with one method and its answer. */
function craft(name, known, answer) {
  const method = 'plugin:./mine.so';
  const element = (id) => new RegExp(`(<script id="${id}"[^>]*>)([^]*?)(</script>)`);
  const html = readFileSync(page('one'), 'utf8');
  const report = JSON.parse(html.match(element('report'))[2]);
  const letter = answer.outcome[0];
  Object.assign(report, {
    methods: [{ spec: method, claims: true }], groups: [], paper: [], tables: [],
    cases: [['mine.json', 'VF', 'RP', 'by hand', letter, null, null, 'ordinary', 9, {}]],
  });
  const [details] = JSON.parse(gunzipSync(Buffer.from(html.match(element('details-0'))[2], 'base64')));
  Object.assign(details, { answers: { [method]: answer }, cells: [], traces: [], case: known });
  mkdirSync(data(name));
  writeFileSync(page(name), html
    .replace(element('report'), (_, begin, __, end) => begin + JSON.stringify(report) + end)
    .replace(element('details-0'), (_, begin, __, end) => begin + gzipSync(JSON.stringify([details])).toString('base64') + end));
}
// A point that falls through a triangle at t = 1/2, and a plug-in that reports it at 3/4.
const falling = (motion, more = {}) => ({
  format: 'ccdfuzz-case', version: 2, t_max: 1, ...more,
  patches: [
    { shape: 'triangle', degree: 1, positions: [[0, 0, 0], [0, 4, 0], [4, 0, 0]], ...motion[0] },
    { shape: 'point', positions: [[0, 1, 1]], ...motion[1] }],
  truth: { collides: true, witness: { t: '1/2', uv: [['1/4', '1/4'], ['0', '0']] } },
  origin: {},
});
// A cube of side 1 that falls on a slab, at 1 per unit of time, and touches it at t = 1/2.
const box = (low, high) => Array.from({ length: 8 }, (_, i) => [0, 1, 2].map((k) => (i & (1 << k) ? high : low)[k]));
const cubes = {
  format: 'ccdfuzz-case', version: 2, t_max: 1,
  patches: [
    { shape: 'hull', positions: box([-4, -4, -1], [4, 4, 0]), velocities: [[0, 0, 0]] },
    { shape: 'hull', positions: box([0, 0, 0.5], [1, 1, 1.5]), velocities: [[0, 0, -1]], radius: 0 }],
  truth: { collides: true, witness: { t: '1/2', weights: [['0', '0', '0', '0', '49/256', '63/256', '63/256', '81/256'], ['1/4', '1/4', '1/4', '1/4', '0', '0', '0', '0']] } },
  origin: {},
};
// A ball and a capsule that come as near as their radii and a separation at t = 1.
const balls = {
  format: 'ccdfuzz-case', version: 2, t_max: 2, separation: 0.25,
  patches: [
    { shape: 'hull', positions: [[0, 0, 0]], velocities: [[0, 0, 0]], radius: 0.5 },
    { shape: 'hull', positions: [[0, 2, 0], [1, 2, 0]], velocities: [[0, -1, 0]], radius: 0.25 }],
  truth: { collides: true, witness: { t: '1', weights: [['1'], ['1', '0']] } }, origin: {},
};
// A quarter of a cylinder of radius 5, which needs weights, and a point that comes from twice as far at t = 1/2.
const kArc = [[5, 0], [5, 5], [0, 5]].flatMap(([x, y]) => [[x, y, 0], [x, y, 4]]);
const cylinder = (motion) => ({
  format: 'ccdfuzz-case', version: 2, t_max: 1,
  patches: [
    { shape: 'tensor', degree: [2, 1], positions: kArc, weights: [1, 1, 1, 1, 2, 2], ...motion[0] },
    { shape: 'point', positions: [[6, 8, 2]], ...motion[1] }],
  truth: { collides: true, witness: { t: '1/2', uv: [['1/2', '1/2'], ['0', '0']] } }, origin: {},
});
/** The same without a hole beside the contact, and without its borders. */
const trimmed = (known) => {
  const [patch, point] = known.patches;
  const trim = [[[0.125, 0.125], [0.875, 0.125], [0.875, 0.875], [0.125, 0.875]], [[0.25, 0.25], [0.5, 0.25], [0.5, 0.75], [0.25, 0.75]]];
  return { ...known, patches: [{ ...patch, trim }, point] };
};
const kVelocities = [{ velocities: [[0, 0, 0], [0, 0, 0], [0, 0, 0]] }, { velocities: [[2, 0, -2]] }];
const kEnds = [{ ends: [[0, 0, 0], [0, 4, 0], [4, 0, 0]] }, { ends: [[2, 1, -1]] }];
// A trimmed piece of a sphere of radius 25, which meets a piece of a torus at t = 1/2. `prove` proves that it does not before.
const kQuarter = [[1, 0], [1, 1], [0, 1]];
const revolved = (profile, place) => profile.flatMap(([r, z]) => kQuarter.map(([x, y]) => place([r * x, r * y, z])));
const kRevolved = { shape: 'tensor', degree: [2, 2], weights: [1, 1, 2, 1, 1, 2, 2, 2, 4] };
const still = (velocity) => Array(9).fill(velocity);
mkdirSync(data('sphere-entry'));
writeFileSync(data('sphere.json'), JSON.stringify({
  format: 'ccdfuzz-case', version: 2, t_max: 1,
  patches: [
    { ...kRevolved, positions: revolved(kQuarter, ([x, y, z]) => [88 - 25 * x, 66 - 25 * y, 45 - 25 * z]), velocities: still([-32, -24, -30]), trim: [[[0.125, 0.125], [0.875, 0.25], [0.25, 0.875]]] },
    { ...kRevolved, positions: revolved([[75, 0], [75, 25], [50, 25]], (p) => p), velocities: still([0, 0, 0]) }],
  truth: { collides: true, witness: { t: '1/2', uv: [['1/3', '1/3'], ['1/3', '1/3']] } }, origin: {}, expect: { 'tdibm-c': 'correct' },
}));
run('prove', data('sphere.json'), '-o', data('sphere-entry/sphere.json'));
run('report', data('sphere-entry'), '-o', data('sphere'));
craft('by-velocities', falling(kVelocities), { outcome: 'late', toi: 0.75 });
craft('by-ends', falling(kEnds), { outcome: 'late', toi: 0.75 });
craft('no-contact', { ...falling(kVelocities), truth: { collides: false } }, { outcome: 'false_positive', toi: 0.75 });
craft('cubes', cubes, { outcome: 'late', toi: 0.75 });
craft('balls', balls, { outcome: 'missed', toi: null });
craft('rational', cylinder([{ velocities: kArc.map(() => [0, 0, 0]) }, { velocities: [[-6, -8, 0]] }]), { outcome: 'missed', toi: null });
craft('trimmed', trimmed(cylinder([{ velocities: kArc.map(() => [0, 0, 0]) }, { velocities: [[-6, -8, 0]] }])), { outcome: 'missed', toi: null });
craft('rational-by-ends', cylinder([{ ends: kArc }, { ends: [[0, 0, 2]] }]), { outcome: 'missed', toi: null });
craft('separated', falling(kVelocities, { separation: 0.25 }), { outcome: 'missed', toi: null });

const browser = await chromium.launch({
  timeout: kPatience,
  executablePath: kBrowser,
  args: ['--no-sandbox', '--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--ignore-gpu-blocklist'],
});

async function open(name, options = {}, hash = '') {
  const context = await browser.newContext({ viewport: { width: 1120, height: 900 }, ...options });
  context.setDefaultTimeout(kPatience);
  const tab = await context.newPage();
  const errors = [];
  tab.on('console', (m) => m.type() === 'error' && errors.push(m.text()));
  tab.on('pageerror', (e) => errors.push(String(e)));
  const requests = [];
  tab.on('request', (r) => !/^(file|data|blob):/.test(r.url()) && requests.push(r.url()));
  await tab.goto(pathToFileURL(page(name)) + hash);
  await tab.waitForSelector('html[data-ready]');
  return { tab, errors, requests, close: () => context.close() };
}
const shot = async (tab, name, options = {}) => {
  const path = join(screenshots && kInReadme.includes(name) ? screenshots : work, `${name}.png`);
  await tab.screenshot({ path, ...options });
  return path;
};
const tabsOf = (tab) => tab.$$eval('[role=tab]', (all) => all.map((t) => t.id.replace('tab-', '')));
/** How far the page is wider than the window. */
const overhang = (tab) => tab.evaluate(() => document.documentElement.scrollWidth - innerWidth);
/** The texts in sight whose contrast to what is behind them is below 4.5, as WCAG 2 measures it. */
const faintTexts = (tab) => tab.evaluate(() => {
  const pen = Object.assign(document.createElement('canvas'), { width: 1, height: 1 }).getContext('2d', { willReadFrequently: true });
  const paint = (colour, alpha = 1) => {
    Object.assign(pen, { globalAlpha: alpha, fillStyle: colour });
    pen.fillRect(0, 0, 1, 1);
    return [...pen.getImageData(0, 0, 1, 1).data];
  };
  const brightness = (pixel) => pixel.slice(0, 3).map((c) => c / 255)
    .map((c) => (c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4))
    .reduce((sum, c, k) => sum + c * [0.2126, 0.7152, 0.0722][k], 0);
  const faint = new Map();
  for (const one of document.querySelectorAll('body *')) {
    const text = [...one.childNodes].filter((n) => n.nodeType === Node.TEXT_NODE).map((n) => n.data.trim()).join('');
    const { width, height } = one.getBoundingClientRect();
    if (!text || width === 0 || height === 0 || one.closest('script, style, option')) continue;
    const line = [];
    for (let at = one; at; at = at.parentElement) line.unshift(at);
    let ground = paint('#fff');
    let opacity = 1;
    for (const at of line) {
      const style = getComputedStyle(at);
      opacity *= Number(style.opacity);
      ground = paint(style.backgroundColor);
    }
    const style = getComputedStyle(one);
    const ink = paint(one instanceof SVGElement ? style.fill : style.color, opacity);
    const [a, b] = [brightness(ground), brightness(ink)].sort((x, y) => y - x);
    const contrast = (a + 0.05) / (b + 0.05);
    if (contrast < 4.5) faint.set(`${one.tagName}.${one.getAttribute('class')}`, `${text.slice(0, 30)}: ${contrast.toFixed(2)}`);
  }
  return [...faint];
});
const openTab = (tab, name) => tab.click(`#tab-${name}`);
const stagePicture = (tab) => tab.evaluate(() => document.querySelector('.stage canvas').toDataURL());
const waitForCase = (tab) => tab.waitForFunction(() => document.querySelector('.stage canvas')?.width > 300 && document.querySelector('.numbers td'));

/** What a button saves. */
async function saved(tab, selector) {
  const [download] = await Promise.all([tab.waitForEvent('download'), tab.click(selector)]);
  return { name: download.suggestedFilename(), bytes: readFileSync(await download.path()) };
}
async function savedCsv(tab, selector) {
  const { name, bytes } = await saved(tab, selector);
  return { name, lines: bytes.toString().trimEnd().split('\n') };
}
/** A line of CSV that has no value in a field. */
const bad = (line) => line.split(',').some((field) => field === 'undefined' || field === 'NaN');
/** Figures are saved as their data and as a picture of many colours. */
async function claimSaved(tab, panel, titles) {
  for (const title of titles) {
    const figure = `#panel-${panel} figure.card:has(h3:text-is("${title}"))`;
    const { name, lines } = await savedCsv(tab, `${figure} button:text-is("CSV")`);
    claim(`${title}: its data are saved`, name.endsWith('.csv') && lines.length > 1 && lines[0].includes(','), name, lines.slice(0, 2));
    claim(`${title}: no field is undefined or NaN`, !lines.some(bad), lines.find(bad));
    const png = await saved(tab, `${figure} button:text-is("PNG")`);
    const colours = await tab.evaluate(async (base64) => {
      const image = await createImageBitmap(await (await fetch(`data:image/png;base64,${base64}`)).blob());
      const pen = Object.assign(document.createElement('canvas'), { width: image.width, height: image.height }).getContext('2d');
      pen.drawImage(image, 0, 0);
      return new Set(new Uint32Array(pen.getImageData(0, 0, image.width, image.height).data.buffer)).size;
    }, png.bytes.toString('base64'));
    claim(`${title}: its picture is saved`, png.name === name.replace('.csv', '.png') && colours > 20, png.name, colours);
    if (panel === 'figures') writeFileSync(join(work, png.name), png.bytes);
  }
}

// Every tab of every report, without an error and without the network.
for (const name of ['none', 'one', 'many', 'corpus', 'engines', 'evaluation', 'hunt', 'board', 'bodies']) {
  const { tab, errors, requests, close } = await open(name);
  const tabs = await tabsOf(tab);
  for (const one of tabs) {
    await openTab(tab, one);
    const filled = await tab.$eval(`#panel-${one}`, (p) => !p.hidden && p.innerText.trim().length > 20);
    claim(`${name}: tab ${one} shows something`, filled);
    if (one === 'cases') await waitForCase(tab);
  }
  const megabytes = statSync(page(name)).size / 2 ** 20;
  claim(`${name}: the page is below 20 MB`, megabytes < 20, megabytes);
  claim(`${name}: no console error`, errors.length === 0, errors);
  claim(`${name}: no request`, requests.length === 0, requests);
  console.log(`  ${name}: ${tabs.join(', ')}; ${megabytes.toFixed(2)} MB`);
  await close();
}

// Which box lost the contact, at which level, by how many ulps: said at once for the one entry.
{
  const { tab, close } = await open('one', {}, '#cases');
  await waitForCase(tab);
  const sentence = await tab.innerText('.sentence');
  claim('the sentence names the level, the axis and the ulps', /level \d+ of \d+/.test(sentence) && /axis \d+/.test(sentence) && /ulp|just touch|no direction/.test(sentence), sentence);
  claim('the level of the loss is marked in the ladder', (await tab.$$('.rung.lost')).length === 1);
  const exact = await tab.evaluate(() => document.querySelector('.numbers').innerText.includes('the two patches differ there'));
  claim('the witness is exact in the page’s own arithmetic', !exact);

  const before = await stagePicture(tab);
  const text = await tab.innerText('.time-text');
  await tab.$eval('input.time', (s) => { s.value = 100; s.dispatchEvent(new Event('input')); });
  claim('the slider moves the patches', before !== (await stagePicture(tab)));
  claim('the slider says another time', text !== (await tab.innerText('.time-text')));
  await tab.click('text=Gap');
  claim('the gap is magnified', !(await tab.innerText('.zoom-text')).includes('whole'), await tab.innerText('.zoom-text'));

  for (const [label, holds] of [
    ['Copy case (JSON)', (t) => JSON.parse(t).format === 'ccdfuzz-case'],
    ['Copy command', (t) => /ccdfuzz query \S+ --methods \S+/.test(t)],
    ['Copy GoogleTest', (t) => t === readFileSync(data('one.cpp'), 'utf8')],
  ]) {
    const button = tab.locator('button.copy', { hasText: label });
    const handle = await button.elementHandle();
    await handle.click();
    await tab.waitForFunction((b) => b.dataset.copied, handle);
    claim(`the button "${label}" copies it`, holds(await handle.getAttribute('data-copied')), await handle.getAttribute('data-copied'));
  }

  claim('the slice cuts both patches', await tab.evaluate(() => ['--patch-1', '--patch-2'].every((name) => document.querySelector(`.slice svg [stroke="var(${name})"] path`))));
  const slice = await savedCsv(tab, '.slice button:text-is("CSV")');
  claim('the slice is saved as CSV', ['1', '2'].every((patch) => slice.lines.some((l) => l.startsWith(`${patch},shown,`))) && !slice.lines.some(bad), slice.lines.slice(0, 3));
  const picture = await saved(tab, '.slice button:text-is("PNG")');
  claim('the slice is saved as PNG', picture.name === first.replace('.json', '-slice.png') && picture.bytes.length > 3000, picture.name, picture.bytes.length);
  for (const plot of await tab.$$('.trace-plot')) {
    const title = await (await plot.$('h3')).innerText();
    const { name, lines } = await savedCsv(tab, `.trace-plot:has(h3:text-is("${title}")) button:text-is("CSV")`);
    claim(`${title} is saved as CSV`, name.endsWith('.csv') && lines.length > 1 && !lines.some(bad), name, lines.slice(0, 2));
  }

  // Whole, and as far as the gap is magnified: what is in the picture is in the file.
  const savedGltf = async () => {
    const { name, bytes } = await saved(tab, 'text=Save glTF');
    const { issues } = await validateBytes(new Uint8Array(bytes));
    claim('the button "Save glTF" saves what the validator accepts', issues.numErrors + issues.numWarnings === 0, issues.messages);
    claim('the glTF has the name of its case', name === first.replace('.json', '.gltf'), name);
    return JSON.parse(bytes);
  };
  const near = await savedGltf();
  await tab.click('text=Whole');
  const whole = await savedGltf();
  const seconds = ({ scenes: [{ extras: { times: [from, to] } }] }) => to - from;
  claim('the glTF of a magnified picture is of its time', near.animations.length === 1 && seconds(near) < seconds(whole), seconds(near), seconds(whole));
  await close();
}

// A plug-in's late answer: its toi on the time line and in the slice. Ends say the same as velocities.
{
  const { tab, close } = await open('by-velocities', {}, '#cases');
  await waitForCase(tab);
  const seen = async (one) => [await one.innerText('.numbers'), (await savedCsv(one, '.slice button:text-is("CSV")')).lines];
  const [numbers, lines] = await seen(tab);
  claim('a find opens at t*', (await tab.innerText('.time-text')) === 't = t* = 0.5', await tab.innerText('.time-text'));
  claim('the slice stands beside the 3-D view', await tab.evaluate(() => {
    const [stage, slice] = ['.stage', '.slice'].map((s) => document.querySelector(s).getBoundingClientRect());
    return slice.left >= stage.right && slice.top === stage.top;
  }));
  const names = await tab.$$eval('.track .name', (all) => all.map((one) => [one.innerText, one.style.left]));
  claim('t* and the plug-in’s toi are on the time line', JSON.stringify(names) === '[["t*","50%"],["toi","75%"]]', names);
  // It falls by 2 per unit of time, and toi − t* = 1/4.
  claim('the slice says how far the patches overlap at that time', (await tab.innerText('.slice figcaption')).includes('at the time that the method reports, 0.5 past patch 1'), await tab.innerText('.slice figcaption'));
  const places = (when) => lines.map((l) => l.split(',')).filter(([patch, at]) => patch === '2' && at === when).map((l) => l.slice(3).map(Number));
  claim('the slice has the point at the contact, and past it at the toi', places('shown')[0]?.every((x) => Math.abs(x) < 1e-12) &&
    Math.abs(places('after')[0]?.[1] + 0.5) < 1e-12, lines);
  const ends = await open('by-ends', {}, '#cases');
  await waitForCase(ends.tab);
  claim('positions at t = 1 in place of velocities show the same', JSON.stringify(await seen(ends.tab)) === JSON.stringify([numbers, lines]), await seen(ends.tab), numbers);
  await ends.close();
  const apart = await open('separated', {}, '#cases');
  await waitForCase(apart.tab);
  claim('a separation is in the head of its case', (await apart.tab.innerText('.case-title')).includes('separation 0.25'), await apart.tab.innerText('.case-title'));
  claim('no separation is in the head of a case without one', !(await tab.innerText('.case-title')).includes('separation'));
  const none = await open('no-contact', {}, '#cases');
  await waitForCase(none.tab);
  claim('a false positive opens at the time that the method reports', (await none.tab.innerText('.time-text')) === 't = t_max − 0.25', await none.tab.innerText('.time-text'));
  claim('its slice is of no contact', (await none.tab.innerText('.slice h3')) === 'Slice through both patches');
  await none.close();
  await openTab(tab, 'overview');
  claim('a method that claims no false negative is named as guaranteed', (await tab.innerText('.matrix')).includes('guaranteed') && (await tab.innerText('.facts')).includes('guarantee broken'));
  await apart.close();
  await close();
}

// Bodies, separations and weights: what is drawn is what touches, in 3-D, in the slice and in files.
{
  const sliceOf = async (tab) => (await savedCsv(tab, '.slice button:text-is("CSV")')).lines.slice(1).map((l) => l.split(','));
  const placesOf = (rows, patch, when) => rows.filter(([p, w]) => p === patch && w === when).flatMap((row) => [row.slice(3, 5), row.slice(5)].map((p) => p.map(Number)));
  const heights = (places) => [Math.min(...places.map(([, y]) => y)), Math.max(...places.map(([, y]) => y))];
  const near = (a, b, by = 1e-9) => Math.abs(a - b) <= by;
  for (const name of ['cubes', 'balls', 'rational', 'rational-by-ends', 'trimmed', 'sphere']) {
    const { tab, errors, close } = await open(name, {}, '#cases');
    await waitForCase(tab);
    claim(`${name}: it opens at t*`, (await tab.innerText('.time-text')).startsWith('t = t* = '), await tab.innerText('.time-text'));
    const file = await saved(tab, 'text=Save glTF');
    const { issues } = await validateBytes(new Uint8Array(file.bytes));
    claim(`${name}: its glTF is valid`, issues.numErrors + issues.numWarnings === 0, issues.messages);
    const names = JSON.parse(file.bytes).nodes.map((node) => node.name);
    claim(`${name}: its glTF has both, and the contact`, [/^(body|patch) 1$/, /^(body|patch) 2$/, /^contact$/].every((one) => names.some((n) => one.test(n))), names);
    const png = await saved(tab, '.slice button:text-is("PNG")');
    claim(`${name}: its slice is saved as PNG`, png.bytes.length > 3000, png.bytes.length);
    const rows = await sliceOf(tab);
    claim(`${name}: every line of the slice has its numbers`, rows.length > 0 && !rows.some((row) => bad(row.join())), rows.slice(0, 3));
    const picture = await stagePicture(tab);
    await tab.$eval('input.time', (s) => { s.value = 1000; s.dispatchEvent(new Event('input')); });
    const moved = await sliceOf(tab);
    claim(`${name}: the slider moves both pictures`, picture !== (await stagePicture(tab)) && JSON.stringify(rows) !== JSON.stringify(moved));
    claim(`${name}: no console error`, errors.length === 0, errors);
    const words = await tab.innerText('.slice figcaption');
    const levels = await tab.isVisible('.ladder');
    if (name === 'cubes') {
      claim('bodies that touch do not overlap', placesOf(rows, 'both', 'shown').length === 0, rows);
      claim('the slice has how far they overlap at the toi', heights(placesOf(rows, 'both', 'after')).every((y, k) => near(y, k - 1 && -0.25)), placesOf(rows, 'both', 'after'));
      claim('and at the time shown', heights(placesOf(moved, 'both', 'shown')).every((y, k) => near(y, k - 1 && -0.5)), placesOf(moved, 'both', 'shown'));
      claim('the caption says so', words.includes('0.25 past body 1') && words.includes('Red: where they overlap.'), words);
      claim('the witness of bodies is in the numbers', /weights of the points of body 2\s+1\/4, 1\/4/.test(await tab.innerText('.numbers')), await tab.innerText('.numbers'));
    }
    if (name === 'balls') {
      const off = placesOf(rows, '1', 'shown').map(([x, y]) => Math.hypot(x, y + 0.5) - 0.5);
      claim('a ball is cut in a circle', off.length > 40 && off.every((x) => x <= 1e-9 && x > -0.005), Math.min(...off), Math.max(...off));
      const [low] = heights(placesOf(rows, '2', 'shown'));
      claim('they are a separation apart', near(low, 0.25), low);
      claim('the separation is told', words.includes('within the separation of 0.25 of the dot'), words);
    }
    if (name.startsWith('rational')) {
      const off = placesOf(rows, '1', 'shown').map(([x, y]) => Math.hypot(x, y + 5) - 5);
      claim(`${name}: a patch with weights is cut in its circle`, off.length > 40 && off.every((x) => x <= 1e-9 && x > -0.005), Math.min(...off), Math.max(...off));
      claim(`${name}: its title says that it is rational`, (await tab.innerText('.case-title')).includes('rational tensor 2×1'));
    }
    if (name === 'trimmed') {
      const cut = placesOf(rows, '1', 'shown').map(([x]) => x).sort((a, b) => a - b);
      const widest = Math.max(...cut.slice(1).map((x, i) => x - cut[i]));
      claim('a trimmed patch is not drawn in its hole', widest > 1 && cut.some((x) => Math.abs(x) < 0.05), widest, cut);
      claim('a trimmed patch ends at its trim', cut.at(-1) - cut[0] < 6.5 && cut.at(-1) - cut[0] > 5, cut[0], cut.at(-1));
    }
    if (name === 'sphere') {
      const numbers = await tab.innerText('.numbers');
      claim('a trimmed sphere meets a torus in a point', /contact point\s+56, 42, 15/.test(numbers), numbers);
      claim('that it does not before is proven', /no contact before\s+1\/2, by certificate P/.test(numbers), numbers);
      claim('its title says what they are', (await tab.innerText('.case-title')).includes('trimmed rational tensor 2×2 against rational tensor 2×2'));
      const off = placesOf(rows, '2', 'shown').length;
      claim('both are in the slice', off > 40 && placesOf(rows, '1', 'shown').length > 20, off);
    }
    claim(`${name}: levels are those of patches`, levels === !['cubes', 'balls'].includes(name), levels);
    await close();
  }
}

// The same of a hunt, in which the plug-in is asked.
{
  const { tab, errors, close } = await open('late-hunt', {}, '#cases');
  await waitForCase(tab);
  await tab.selectOption('select[aria-label=Outcome]', 'l');
  await tab.click('.item');
  await tab.waitForSelector('.chip.late[aria-pressed=true]');
  const names = await tab.$$eval('.track .name', (all) => all.map((one) => one.innerText).join(' '));
  claim('a hunt’s page has the toi of a plug-in', names.includes('t*') && names.includes('toi') && /toi of plugin-exec/.test(await tab.innerText('.numbers')), names, await tab.innerText('.numbers'));
  claim('a hunt’s page: no console error', errors.length === 0, errors);
  await close();
}

// Finds by failure: one row each, the best, and all where it is opened; missed before late, ordinary first.
{
  const { tab, close } = await open('corpus', {}, '#cases');
  await waitForCase(tab);
  const report = await tab.evaluate(() => JSON.parse(document.getElementById('report').textContent));
  const expected = new Map();
  for (const [, contact, kind, , outcomes, , , setting, bits, causes] of report.cases) {
    const failed = report.methods.map((m, at) => [m.spec, outcomes[at]]).filter(([, letter]) => 'mlfe'.includes(letter));
    const add = (key, rank) => expected.set(key, [...(expected.get(key) ?? []), rank]);
    for (const [method, letter] of failed) add([method, contact, causes[method] ?? ''].join(), ['mlfe'.indexOf(letter), ['ordinary', 'at an end', 'sliding', 'touching at 0', 'degenerate', 'extreme'].indexOf(setting), bits]);
    if (failed.length === 0) add([contact, kind].join(), [9, 0, 0]);
  }
  const rows = () => tab.$eval('.rows', (r) => r.clientHeight / 46);
  claim('a row for each failure', (await rows()) === expected.size, await rows(), expected.size);
  claim('the count says how many', (await tab.innerText('.count')).includes(`${expected.size} groups`), await tab.innerText('.count'));
  const largest = Math.max(...[...expected.values()].map((members) => members.length));
  const fold = tab.locator('.fold').first();
  const hidden = Number((await fold.innerText()).replace(/\D/g, '')) - 1;
  claim('a group says how many it has', hidden > 0 && hidden < largest, hidden, largest);
  await fold.click();
  claim('a click shows all of a failure', (await rows()) === expected.size + hidden, await rows(), hidden);
  const members = await tab.$$eval('.item.more small', (all) => all.map((one) => ['missed', 'late', 'false', 'error'].findIndex((outcome) => one.innerText.startsWith(outcome))));
  claim('missed comes before late', members.length > 0 && members.every((x, k) => x >= 0 && (k === 0 || members[k - 1] <= x)), members);
  await tab.focus('.list');
  for (const key of ['Home', 'ArrowLeft']) await tab.keyboard.press(key);
  await fold.click();
  claim('a second click folds them', (await rows()) <= expected.size + hidden, await rows());
  const best = [...expected.values()].flat().sort((a, b) => a.map((x, k) => x - b[k]).find((x) => x !== 0) ?? 0)[0];
  const shown = await tab.evaluate(async (want) => {
    const { cases } = JSON.parse(document.getElementById('report').textContent);
    const id = document.querySelector('.case-id').title;
    const one = cases.find((c) => c[0] === id);
    return [one[7] === ['ordinary', 'at an end', 'sliding', 'touching at 0', 'degenerate', 'extreme'][want[1]], one[8] === want[2], one[4].includes('mlfe'[want[0]])];
  }, best);
  claim('the first one shown is the most convincing', shown.every(Boolean), shown, best);
  await close();
}

// Thousands: interactive soon, and the document stays small.
{
  const start = performance.now();
  const { tab, close } = await open('many', {}, '#cases');
  await waitForCase(tab);
  const seconds = (performance.now() - start) / 1000;
  const interactive = await tab.evaluate(() => performance.getEntriesByType('navigation')[0].domInteractive / 1000);
  const count = await tab.evaluate(() => JSON.parse(document.getElementById('report').textContent).cases.length);
  claim('thousands: 5,000 cases are in the page', count === 5000, count);
  const nodes = await tab.evaluate(() => document.querySelectorAll('*').length);
  claim('thousands: no more of them in the document than fit', nodes < 2500, nodes);
  claim('thousands: no command names a line of a data set as if it were a file', !(await tab.$('.case .command')));
  const shown = () => tab.innerText('.case-id');
  const before = await shown();
  await tab.focus('.list');
  await tab.keyboard.press('ArrowRight');  // shows all of the first failure
  await tab.keyboard.press('End');
  await tab.waitForFunction((b) => document.querySelector('.case-id').innerText !== b, before);
  claim('thousands: the last one opens by key', (await shown()) !== before);
  await tab.selectOption('select[aria-label=Outcome]', 'm');
  const listed = await savedCsv(tab, '.side button.copy');
  claim('thousands: the answers to the cases shown are saved as CSV', listed.lines.length === 5001 && listed.lines[0] === 'case,class,kind,generator,method,outcome,toi', listed.lines.length, listed.lines[0]);
  claim('thousands: filters', /5000 cases/.test(await tab.innerText('.count')), await tab.innerText('.count'));
  console.log(`  many: interactive after ${interactive.toFixed(2)} s, with a case shown after ${seconds.toFixed(2)} s`);
  await close();
}

// Plots have their points, tables their rows.
{
  const { tab, close } = await open('evaluation', { viewport: { width: 1020, height: 1130 } }, '#figures');
  const expected = await tab.evaluate(() => {
    const groups = JSON.parse(document.getElementById('report').textContent).groups.filter((g) => g.positives > 0);
    return 2 * new Set(groups.map((g) => `${g.class} ${g.method}`)).size;
  });
  const bars = await tab.$$eval('figure.card:first-of-type svg [aria-label=bar] rect', (all) => all.length);
  claim('Fig. 8 a has a bar for each class, method and way to fail', bars === expected, bars, expected);
  claim('Fig. 9 has a panel for each method', (await tab.$$('.with-inset')).length === 5);
  const queries = await tab.evaluate(() => [...document.querySelectorAll('.with-inset > figure, .with-inset > svg')].map((s) => s.querySelectorAll('[aria-label=rect] rect').length));
  claim('Fig. 9: every panel has its bars', queries.every((n) => n > 2), queries);
  claim('Fig. 5 has its bars', (await tab.$$eval('figure.card', (all) => all.find((f) => f.innerText.includes('Fig. 5'))?.querySelectorAll('rect').length)) > 5);
  await shot(tab, 'figures');
  const titles = await tab.$$eval('#panel-figures h3', (all) => all.map((t) => t.innerText));
  claim('Figs. 5, 8 a, 8 b and 9 are there', ['5', '8 a', '8 b', '9'].every((n) => titles.some((t) => t.includes(`(Fig. ${n})`))), titles);
  await claimSaved(tab, 'figures', titles);
  await openTab(tab, 'tables');
  claim('Table 1 has a row for each class', (await tab.$$('#table-1 tbody tr')).length === 6);
  const tables = await tab.$$eval('#panel-tables .table-card', (all) => all.map((t) => [t.id, t.querySelectorAll('tbody tr').length]));
  for (const [id, rows] of tables) {
    const { name, lines } = await savedCsv(tab, `#${id} button.copy`);
    claim(`${id} is saved as CSV`, name === `${id}.csv` && lines.length === 1 + rows, name, lines.length, rows);
  }
  claim('Tables 1, 2 and all groups are there', ['table-1', 'table-2', 'groups'].every((id) => tables.some(([other]) => other === id)), tables);
  await close();
}

// Times of queries that a budget cut short.
{
  const { tab, close } = await open('cut', {}, '#tables');
  const cells = await tab.$$eval('#table-1 tbody td', (all) => all.map((e) => e.innerText));
  claim('a time that would be longer is marked', cells.some((text) => /^≥ [\d.]+$/.test(text)), cells);
  const { lines } = await savedCsv(tab, '#table-1 button.copy');
  claim('and is a number in the CSV', lines.some((line) => /^Face-Face,[\d.]+,/.test(line)), lines);
  await close();
}

// A hunt's course.
{
  const { tab, errors, close } = await open('hunt', { viewport: { width: 1120, height: 1000 } }, '#hunt');
  const { course } = await tab.evaluate(() => JSON.parse(document.getElementById('report').textContent));
  const figure = (title, what) => tab.$$eval('#panel-hunt figure.card', (all, [t, w]) =>
    [...(all.find((f) => f.querySelector('h3').innerText === t)?.querySelectorAll(w) ?? [])].map((e) => e.getAttribute('d') ?? Number(e.getAttribute('height'))), [title, what]);
  for (const title of ['Queries', 'Mutants']) {
    const bars = await figure(title, '[aria-label=rect] rect');
    claim(`hunt: ${title} a second has a bar a time`, bars.length > 3 && bars.some((height) => height > 10), bars);
  }
  const least = course.samples.at(-1)[4];
  const known = least.filter((m) => m !== null).length;
  const margins = await figure('Smallest margins', '[aria-label=line] path');
  claim('hunt: margins have a line for each method that was traced', known > 0 && margins.length === known, margins.length, least);
  claim('hunt: counterexamples have their line', (await figure('Counterexamples', '[aria-label=line] path')).some((d) => d.split(',').length > 3));
  await shot(tab, 'hunt');
  await claimSaved(tab, 'hunt', ['Queries', 'Mutants', 'Counterexamples', 'Smallest margins']);
  claim('hunt: no script errors', errors.length === 0, errors);
  await close();
}

// The scoreboard.
{
  const { tab, errors, close } = await open('board', { viewport: { width: 1120, height: 1000 } }, '#scoreboard');
  const scoreboard = await tab.evaluate(() => JSON.parse(document.getElementById('scoreboard').textContent));
  await claimSaved(tab, 'scoreboard', ['CPU time to a kill, fault by fault']);
  for (const [id, rows] of [['drivers', scoreboard.drivers.length], ['faults', new Set(scoreboard.rows.map((r) => r.fault)).size - 1]]) {
    const { lines } = await savedCsv(tab, `#${id} button.copy`);
    claim(`scoreboard: ${id} are saved as CSV`, lines.length === 1 + rows, lines.length, rows);
  }
  claim('scoreboard: a row for each driver', (await tab.$$('#drivers tbody tr')).length === scoreboard.drivers.length);
  const asked = scoreboard.rows.filter((r) => r.fault !== 'none' && !r.equivalent);
  const dots = await tab.$$eval('#panel-scoreboard svg [aria-label=dot] > *', (all) => all.length);
  const perFacet = await tab.$$eval('#panel-scoreboard svg [aria-label=dot] circle, #panel-scoreboard svg [aria-label=dot] path', (all) => all.length);
  claim('scoreboard: a dot for each fault and driver', perFacet === asked.length, perFacet, dots, asked.length);
  const faults = new Set(scoreboard.rows.filter((r) => r.fault !== 'none').map((r) => r.fault)).size;
  const rows = () => tab.$$eval('#faults tbody tr', (all) => all.map((r) => r.innerText.split('\t')));
  claim('scoreboard: a row for each fault', (await rows()).length === faults, (await rows()).length, faults);
  const missed = asked.filter((r) => r.driver === 'hunt' && 2 * r.detected <= r.runs).length;
  await tab.selectOption('select[aria-label="Killed or not"]', '-hunt');
  claim('scoreboard: filters', (await rows()).length === missed, (await rows()).length, missed);
  await tab.selectOption('select[aria-label="Killed or not"]', '+properties');
  await tab.focus('#faults th:nth-child(1) button');
  await tab.keyboard.press('Enter');
  const names = (await rows()).map((r) => r[0].trim());
  claim('scoreboard: sorts, by key', names.length > 9 && names.every((n, i) => i === 0 || names[i - 1] <= n), names.slice(0, 5));
  claim('scoreboard: the sorted column keeps the focus', await tab.evaluate(() => document.activeElement.innerText.startsWith('fault')));
  await tab.fill('input[aria-label="Fault holds"]', 'no such fault');
  claim('scoreboard: finds nothing where there is nothing', (await rows()).length === 0);
  await tab.fill('input[aria-label="Fault holds"]', '');
  await shot(tab, 'scoreboard', { fullPage: false });
  claim('scoreboard: no console error', errors.length === 0, errors);
  await close();
}

// Keyboard alone: from the tabs to a case, its levels and its time.
{
  const { tab, close } = await open('corpus');
  await tab.focus('[role=tab]');
  await tab.keyboard.press('ArrowRight');
  await waitForCase(tab);
  claim('the arrow keys change tabs', await tab.$eval('#tab-cases', (t) => t.getAttribute('aria-selected') === 'true'));
  const reached = new Set();
  for (let i = 0; i < 60; ++i) {
    await tab.keyboard.press('Tab');
    reached.add(await tab.evaluate(() => {
      const at = document.activeElement;
      return at.className?.split?.(' ')[0] || at.tagName.toLowerCase();
    }));
  }
  const wanted = ['list', 'chip', 'canvas', 'rung', 'time', 'zoom', 'copy'];
  claim('the Tab key reaches every control', wanted.every((w) => reached.has(w)), [...reached]);
  const unnamed = await tab.$$eval('button, input, select, [role=listbox]', (all) => all.filter((e) => e.offsetParent && !(e.innerText?.trim() || e.getAttribute('aria-label') || e.placeholder)).length);
  claim('every control has a name', unnamed === 0, unnamed);
  await close();
}

// Light and dark, wide and narrow.
for (const [look, options] of Object.entries({
  light: { colorScheme: 'light' },
  dark: { colorScheme: 'dark' },
  narrow: { colorScheme: 'light', viewport: { width: 400, height: 860 } },
  'narrow and dark': { colorScheme: 'dark', viewport: { width: 400, height: 860 } },
})) {
  for (const name of ['corpus', 'evaluation', 'hunt', 'by-velocities', 'late-hunt', 'bodies', 'cubes', 'balls', 'rational', 'trimmed']) {
    const { tab, close } = await open(name, options);
    for (const one of await tabsOf(tab)) {
      await openTab(tab, one);
      if (one === 'cases') await waitForCase(tab);
      const over = await overhang(tab);
      claim(`${look}: nothing sticks out of ${name}, ${one}`, over <= 0, over);
      const cut = await tab.$$eval('.case, .case-head, .numbers, .controls, .views', (all) => all.filter((e) => e.scrollWidth > e.clientWidth).map((e) => e.className));
      claim(`${look}: nothing of ${name}, ${one} is cut off`, cut.length === 0, cut);
      const faint = await faintTexts(tab);
      claim(`${look}: all texts of ${name}, ${one} have a contrast of 4.5`, faint.length === 0, faint);
    }
    await close();
  }
  const { tab, errors, close } = await open('corpus', options);
  const ground = await tab.evaluate(() => getComputedStyle(document.body).backgroundColor.match(/\d+/g).map(Number)[0]);
  claim(`${look}: the page is ${look.includes('dark') ? 'dark' : 'light'}`, look.includes('dark') ? ground < 80 : ground > 200, ground);
  await shot(tab, `overview-${look}`);
  await openTab(tab, 'cases');
  await waitForCase(tab);
  await tab.selectOption('select[aria-label=Method]', 'tdibm');
  await tab.selectOption('select[aria-label=Class]', 'VF');
  await tab.selectOption('select[aria-label=Outcome]', 'm');
  const before = await tab.innerText('.case-id');
  await tab.click('.item');
  await tab.waitForFunction((b) => document.querySelector('.case-id').innerText !== b, before);
  claim(`${look}: it is shown of the method asked for`, (await tab.innerText('.sentence b')) === 'tdibm', await tab.innerText('.sentence'));
  await shot(tab, `case-${look}`);
  claim(`${look}: no console error`, errors.length === 0, errors);
  await close();
  for (const [name, one] of [['hunt', 'hunt'], ['board', 'scoreboard']]) {
    const opened = await open(name, options, `#${one}`);
    await shot(opened.tab, `${one}-${look}`);
    await opened.close();
  }
}
await browser.close();
console.log(failures === 0 ? 'all as claimed' : `${failures} claims do not hold`);
process.exit(failures === 0 ? 0 : 1);
