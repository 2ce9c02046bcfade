// What became of the contact, in words.
import { h, scientific, ulpsText } from './dom.js';
import { fractionOf, subtract, toNumber } from './exact.js';

/** Which end of the excluded times is on the wrong side of t*: 0 the first, 1 the last. */
function wrongEnd({ excluded, cut }, t) {
  if (cut[0] !== cut[1]) return cut[0] ? 1 : 0;
  const [from, to] = excluded.map((x) => Math.abs(toNumber(subtract(fractionOf(x), t))));
  return from < to ? 0 : 1;
}

/** How a method answered and where it lost the contact: parts of a sentence. tStar: a fraction. */
export function verdict(method, answer, trace, tStar) {
  if (!answer) return [];
  const strong = (text) => h('strong', text);
  const says = {
    missed: ' says that there is no contact. ', late: ' reports the contact too late. ',
    false_positive: ' reports a contact that is none. ', correct: ' answers well. ',
    not_asked: ' refuses this query. ',
  }[answer.outcome] ?? ` is ${answer.outcome}. `;
  const parts = [h('b', method), says];
  if (answer.outcome === 'late' && answer.toi !== null) {
    const late = toNumber(subtract(fractionOf(answer.toi), tStar));
    parts.push('It is late by ', strong(scientific(late)), '. ');
  }
  if (answer.outcome === 'late' && answer.toi === null) parts.push('Its time is not known here: it was not asked again. ');
  if (answer.outcome === 'false_positive' && answer.toi !== null) parts.push(`It stops at t = ${answer.toi}. `);
  const loss = trace?.loss;
  if (loss) {
    parts.push('The contact is lost at ', strong(`level ${loss.level}`), ` of ${Math.max(14, trace.levels)}`);
    if (loss.axis === undefined) parts.push(': no axis claims t*, but what is left of the window leaves it out.');
    else {
      parts.push(': ', strong(`axis ${loss.axis}`), ' claims that these two boxes are apart ');
      const early = wrongEnd(loss, tStar) === 0;
      if (loss.ulps_past === null) parts.push('for all that is left of the time, the contact included');
      else if (loss.ulps_past === 0) parts.push(early ? 'already from' : 'until', ' less than ', strong('1 ulp'), early ? ' before it' : ' after it');
      else parts.push(early ? 'already from ' : 'until ', strong(ulpsText(loss.ulps_past)), early ? ' before it' : ' after it');
      if (loss.overlap !== null && loss.overlap !== undefined) {
        const ulps = loss.overlap / loss.height_ulp;
        parts.push('. In exact arithmetic they ');
        if (loss.overlap === 0) parts.push(strong('just touch'), ' along it: an overlap of 0, which any rounding error turns into a gap.');
        else parts.push('overlap along it by ', strong(scientific(loss.overlap)), ', ', strong(ulpsText(ulps)), ' of their heights.');
      } else parts.push('. The axis is no direction at all: it has run out of the range of doubles.');
    }
  } else if (trace) {
    parts.push(trace.lost ? '' : `The contact is kept through all ${trace.levels} levels`);
    if (!trace.lost) parts.push(trace.margin ? `, by ${ulpsText(trace.margin.ulps)} at the closest (level ${trace.margin.level}).` : '.');
  }
  return parts;
}
