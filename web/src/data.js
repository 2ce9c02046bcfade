// The report in the page: a JSON element at hand, and blocks of compressed details that are opened
// when a case of theirs is.
const text = (id) => document.getElementById(id)?.textContent ?? '';

export const report = JSON.parse(text('report') || '{}');
/** What ccdfuzz-scoreboard wrote, as it stands; null if there is none. */
export const board = JSON.parse(text('scoreboard') || 'null');
const blocks = new Map();

async function inflate(base64) {
  const bytes = Uint8Array.from(atob(base64), (c) => c.charCodeAt(0));
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('gzip'));
  return JSON.parse(await new Response(stream).text());
}

/** What the page holds of case `index`. */
export async function details(index) {
  const block = Math.floor(index / report.cases_per_chunk);
  if (!blocks.has(block)) blocks.set(block, inflate(text(`details-${block}`)));
  return (await blocks.get(block))[index % report.cases_per_chunk];
}

export const kOutcomes = {
  c: 'correct', m: 'missed', l: 'late', f: 'false positive', u: 'undecided', '?': 'unknown', e: 'error',
};
export const isFailure = (letter) => 'mlfe'.includes(letter);

export const cases = (report.cases ?? []).map(
  ([id, contact, kind, generator, outcomes, isNew, worst, setting, bits, causes], index) => ({
    index, id, contact, kind, generator, outcomes, isNew, setting, bits, causes,
    worst: worst && { method: worst[0], level: worst[1], axis: worst[2], ulps: worst[3] },
    failed: report.methods.filter((_, m) => isFailure(outcomes[m])).map((m) => m.spec),
  }),
);

export const kClasses = (() => {
  const order = ['FF', 'EF', 'EE', 'VF', 'VE', 'VV'];
  const found = new Set([...(report.groups ?? []).map((g) => g.class), ...cases.map((c) => c.contact)]);
  return [...order.filter((c) => found.has(c)), ...[...found].filter((c) => !order.includes(c)).sort()];
})();
export const methods = (report.methods ?? []).map((m) => m.spec);
