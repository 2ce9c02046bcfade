// The slice as a figure: both cross-sections at the time shown, and patch 2 before and after it.
import * as Plot from '@observablehq/plot';
import { csv, h, savingHead, scientific, superscript } from './dom.js';
import { beforeAndAfter, convexOf, extentOf, middleOf, overlapOf, pastOf, sectionOf, sliceFrame } from './slice.js';

const kPatch = ['var(--patch-1)', 'var(--patch-2)'];
const kCircle = Array.from({ length: 97 }, (_, k) => [Math.cos, Math.sin].map((f) => f((2 * Math.PI * k) / 96)));
const kRim = 1.15;  // half of the plot, of what it shows

export class SliceView {
  constructor(root, name) {
    this.plot = h('div.slice-plot');
    this.caption = h('figcaption');
    this.figure = h('figure.slice',
      savingHead('Slice through the contact', name, () => csv(this.table()), () => this.figure), this.plot, this.caption);
    root.append(this.figure);
  }

  /** picture: of geometry.js. late: from t* (or t_max) to the time that the method reports, or 0. */
  load({ picture, local, witness, separation, late }) {
    this.picture = picture;
    this.witness = witness;
    this.areBodies = Boolean(local.patches[0].mesh);
    this.noun = this.areBodies ? 'body' : 'patch';
    this.both = this.areBodies ? 'both bodies' : 'both patches';
    this.figure.querySelector('h3').textContent = witness ? 'Slice through the contact' : `Slice through ${this.both}`;
    this.separation = separation;
    this.late = late;
    this.frame = sliceFrame(local, picture, picture.parts.map(({ controls }) => middleOf(controls)));
    this.follow = local.patches[0].terms[0].v;
    const times = witness ? [0] : [0, late];
    this.extent = extentOf(times.flatMap((dt) => [0, 1].map((side) => this.section(side, dt))), witness);
    const [before, after] = witness ? beforeAndAfter(picture.range, this.frame, this.extent * picture.scale, late) : [null, null];
    this.ghosts = [['before', before], ['after', after]].filter(([, dt]) => dt !== null)
      .map(([when, dt]) => ({ when, dt, ...this.section(1, dt) }));
  }

  section(side, dt) {
    const { parts, scale } = this.picture;
    const section = sectionOf(parts[side], this.frame, dt, scale, this.follow);
    return { ...section, area: this.areBodies ? convexOf(section) : [] };
  }

  /** What body 2's section has in common with body 1's, which stays where it is. */
  overlap({ area }) {
    return overlapOf(this.now[0].area, area);
  }

  /** Both at t* + dt. */
  move(dt) {
    this.dt = dt;
    this.now = [0, 1].map((side) => this.section(side, dt));
    this.overlaps = [this.now[1], ...this.ghosts].map((one) => this.overlap(one));
    const { scale } = this.picture;
    const power = Math.floor(Math.log10(scale * this.extent));
    const unit = scale / 10 ** power;
    const label = (name) => (power === 0 ? name : `${name} / 10${superscript(power)}`);
    const lines = (of, key = 'segments') => of[key].map((s) => s.map((x) => x * unit));
    const link = (list, options) => Plot.link(list, { x1: (d) => d[0], y1: (d) => d[1], x2: (d) => d[2], y2: (d) => d[3], strokeLinecap: 'round', clip: true, ...options });
    const dots = (list, options) => Plot.dot(list, { x: (d) => d[0] * unit, y: (d) => d[1] * unit, clip: true, ...options });
    const area = (polygon, options) => Plot.line(polygon, { x: (d) => d[0] * unit, y: (d) => d[1] * unit, curve: 'linear-closed', stroke: 'none', clip: true, ...options });
    const circle = this.separation > 0 && this.witness ? kCircle.map((p) => p.map((x) => (x * this.separation) / scale)) : [];
    const path = this.ghosts.filter(({ when }) => when === 'before').map((ghost) => this.pathOf(ghost.dt).map((x) => x * unit));
    const domain = [-1, 1].map((sign) => sign * kRim * this.extent * unit);
    this.plot.replaceChildren(Plot.plot({
      style: { fontSize: '12px' }, width: 420, height: 396, marginLeft: 48, marginRight: 12, marginTop: 22, marginBottom: 38,
      x: { label: `${label('in the slice')} →`, domain, ticks: 5 },
      y: { label: `↑ ${label(!this.witness ? `from ${this.noun} 1 to ${this.noun} 2` : this.frame.holdsNormal ? 'contact normal' : 'nearest to the contact normal')}`, domain, ticks: 5, grid: true },
      ariaLabel: 'Slice through the contact',
      marks: [
        ...this.now.map((one, s) => area(one.area, { fill: kPatch[s], fillOpacity: 0.22 })),
        ...this.overlaps.map((polygon, k) => area(polygon, { fill: 'var(--alarm)', fillOpacity: k === 0 ? 0.6 : 0.3 })),
        area(circle, { stroke: 'var(--ink)', strokeWidth: 1.2, strokeDasharray: '2,3' }),
        ...this.ghosts.flatMap((ghost) => [
          link(lines(ghost), { stroke: kPatch[1], strokeWidth: 1.5, strokeOpacity: 0.6, strokeDasharray: ghost.when === 'after' ? '5,4' : null }),
          dots(ghost.points, { stroke: kPatch[1], strokeOpacity: 0.6, r: 4 })]),
        ...this.now.flatMap((one, s) => [
          link(lines(one, 'shadow'), { stroke: kPatch[s], strokeWidth: 1.2, strokeDasharray: '1,4' }),
          link(lines(one), { stroke: kPatch[s], strokeWidth: s === 0 ? 5 : 2.5 }),
          dots(one.points, { fill: kPatch[s], r: s === 0 ? 6 : 4.5 })]),
        Plot.arrow(path, { x1: (d) => d[0], y1: (d) => d[1], x2: (d) => d[2], y2: (d) => d[3], stroke: 'var(--ink)', strokeWidth: 1.4, headLength: 7, clip: true }),
        this.witness ? dots([[0, 0]], { fill: 'var(--ink)', stroke: 'var(--card)', r: 3.5 }) : null,
      ],
    }));
    this.caption.textContent = this.words();
  }

  /** The way of patch 2's point of the contact from dt to t*, in the plane. */
  pathOf(dt) {
    const { velocity, across, up } = this.frame;
    const { scale } = this.picture;
    const [x, y] = [across, up].map((axis) => velocity.reduce((sum, v, k) => sum + v * axis[k], 0) / scale);
    const { p } = this.picture.parts[1].patch.terms[0];
    const [x0, y0] = [across, up].map((axis) => p.reduce((sum, v, k) => sum + v * axis[k], 0) / scale);
    return [x0 + dt * x, y0 + dt * y, x0, y0];
  }

  words() {
    const { noun, both } = this;
    const filled = this.overlaps.some((one) => one.length > 0) ? ' Red: where they overlap.' : '';
    if (!this.witness) return `The plane through the middles of ${both}, and where it cuts them at the time shown.${filled}`;
    const touch = this.separation > 0 ? `The circle: what is within the separation of ${scientific(this.separation, 6)} of the dot. At t* ${noun} 2 reaches it.` : 'At t* both meet in the dot.';
    const after = this.ghosts.find(({ when }) => when === 'after');
    const past = after && pastOf(this.frame, after.dt);
    const dashed = !after ? '' : ` Dashed: ${this.late > 0 ? 'at the time that the method reports' : 'after the contact'}, ${past > 0 ? `${scientific(past)} past ${noun} 1` : `beside ${noun} 1`}.`;
    const { holdsNormal, holdsMotion } = this.frame;
    const plane = !holdsMotion ? `the middles of ${both}` : `${holdsNormal ? 'its normal' : both}, along the motion of ${noun} 2 as seen from ${noun} 1`;
    return `The plane through the contact and ${plane}. Thick: both cross-sections at the time shown. ${touch} Pale: ${noun} 2 before it.${dashed}${filled}`;
  }

  /** All lines of the picture, in the lengths of the case. */
  table() {
    const { scale } = this.picture;
    const rows = [['patch', 'when', 'seconds_from_t_star', 'x1', 'y1', 'x2', 'y2']];
    const add = (patch, when, dt, { segments, points, shadow }) => {
      for (const line of [...segments, ...(segments.length + points.length > 0 ? [] : shadow)]) rows.push([patch, when, dt, ...line.map((x) => x * scale)]);
      for (const [x, y] of points) rows.push([patch, when, dt, ...[x, y, x, y].map((c) => c * scale)]);
    };
    this.now.forEach((one, s) => add(s + 1, 'shown', this.dt, one));
    for (const { when, dt, ...ghost } of this.ghosts) add(2, when, dt, ghost);
    this.overlaps.forEach((polygon, k) => {
      const { when, dt } = this.ghosts[k - 1] ?? { when: 'shown', dt: this.dt };
      add('both', when, dt, { segments: polygon.map((p, i) => [...p, ...polygon[(i + 1) % polygon.length]]), points: [], shadow: [] });
    });
    return rows;
  }
}
