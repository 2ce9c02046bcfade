// Finds by failure: which method failed, on which class of contact, by which cause.
import { isFailure, methods } from './data.js';

// The most convincing first.
const kOutcomeOrder = 'mlfe';
const kSettingOrder = ['ordinary', 'at an end', 'sliding', 'touching at 0', 'degenerate', 'extreme'];

const rankOf = ({ row, letter }) => [kOutcomeOrder.indexOf(letter), kSettingOrder.indexOf(row.setting), row.bits, row.index];
const compare = (a, b) => {
  const at = a.rank.findIndex((x, k) => x !== b.rank[k]);
  return at < 0 ? 0 : a.rank[at] - b.rank[at];
};

/**
 * Groups {key, method, contact, cause, members}, members {row, letter, rank}, best first; a case is in one
 * group for each method that failed on it, of those that wanted(letter, method) takes. The other
 * cases are in groups by class and kind, with method null.
 */
export function failureGroups(rows, wanted) {
  const groups = new Map();
  const put = (row, letter, method, cause) => {
    const key = JSON.stringify([method, row.contact, cause]);
    if (!groups.has(key)) groups.set(key, { key, method, contact: row.contact, cause, members: [] });
    const member = { row, letter };
    groups.get(key).members.push({ ...member, rank: rankOf(member) });
  };
  for (const row of rows) {
    const failed = methods.map((method, at) => [method, row.outcomes[at]])
      .filter(([method, letter]) => isFailure(letter) && wanted(letter, method));
    for (const [method, letter] of failed) put(row, letter, method, row.causes[method] ?? '');
    if (failed.length === 0) put(row, '', null, row.kind);
  }
  const all = [...groups.values()];
  for (const group of all) group.members.sort(compare);
  const comesLast = ({ method }) => (method === null ? 1 : 0);
  return all.sort((a, b) => comesLast(a) - comesLast(b) || compare(a.members[0], b.members[0]));
}
