// The levels of subdivision as a ladder, and the bands under the time slider.
import { h, ulpsText } from './dom.js';

/** A button a level: what the trace came to there. chosen: the level that is shown. */
export function ladder(trace, traces, chosen, onLevel) {
  const deepest = Math.max(14, ...traces.map((t) => t.levels));
  const rungs = [];
  for (let level = 0; level <= deepest; ++level) {
    const step = trace?.steps.find((s) => s[0] === level);
    const lost = trace?.loss?.level === level;
    const gone = trace?.loss && level > trace.loss.level;
    const margin = step && step[3] !== null ? `, ${ulpsText(step[3])} to spare` : '';
    const title = lost ? `Level ${level}: the contact is lost here` : gone ? `Level ${level}: not reached` : `Level ${level}${margin}`;
    rungs.push(h('button', {
      type: 'button', title, 'aria-label': title,
      class: `rung ${lost ? 'lost' : gone ? 'gone' : step ? 'kept' : 'idle'}`,
      'aria-pressed': String(level === chosen),
      onclick: () => onLevel(level),
    }, String(level)));
  }
  return rungs;
}

const kTooNear = 12;  // percent of the width, in which two names would meet

/** What the slider passes, over range (from t* on): the method's window, what it excludes, and with their
 * names the contact if there is one, and the toi (from t* on, or null) that the method reports. */
export function bands({ range, step, excluded, toi, contact }) {
  const [lo, hi] = range;
  const place = (dt) => Math.min(100, Math.max(0, (100 * (dt - lo)) / (hi - lo)));
  const band = (name, [from, to], title) =>
    h(`span.${name}`, { style: `left:${place(from)}%;width:${Math.max(0.4, place(to) - place(from))}%`, title });
  const mark = (name, dt, title) => h(`span.${name}`, { style: `left:${place(dt)}%`, title });
  const named = [
    ...(contact ? [{ name: 't*', dt: 0 }] : []),
    ...(toi === null ? [] : [{ name: toi < lo ? '‹ toi' : toi > hi ? 'toi ›' : 'toi', dt: toi }]),
  ].sort((a, b) => a.dt - b.dt);
  const near = named.length === 2 && place(named[1].dt) - place(named[0].dt) < kTooNear;
  const names = near ? [{ name: named.map(({ name }) => name).join(' · '), dt: named[0].dt }] : named;
  const marks = [
    step && band('window', step[1], 'the time that this test starts with'),
    excluded && band('excluded', excluded, 'the time that the axis excludes'),
    contact && mark('contact', 0, 'the contact, t*'),
    toi !== null && mark('toi', toi, 'the time that the method reports'),
    ...names.map(({ name, dt }) => h('span.name', {
      style: `left:${place(dt)}%;transform:translateX(-${place(dt)}%)`,
    }, name)),
  ];
  return marks.filter(Boolean);
}
