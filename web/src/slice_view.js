// The slice as a figure: both cross-sections at the time shown, and patch 2 before and after it.
import * as Plot from '@observablehq/plot';
import { csv, h, savingHead, scientific, superscript } from './dom.js';
import { beforeAndAfter, extentOf, middleOf, pastOf, sectionOf, sliceFrame } from './slice.js';

const kPatch = ['var(--patch-1)', 'var(--patch-2)'];
const kRim = 1.15;  // half of the plot, of what it shows

export class SliceView {
  constructor(root, name) {
    this.plot = h('div.slice-plot');
    this.caption = h('figcaption');
    this.figure = h('figure.slice',
      savingHead('Slice through the contact', name, () => csv(this.table()), () => this.figure), this.plot, this.caption);
    root.append(this.figure);
  }

  /** picture: of geometry.js. late: from t* to the time that the method reports, if it is late. */
  load({ picture, local, witness, separation, late }) {
    this.picture = picture;
    this.witness = witness;
    this.figure.querySelector('h3').textContent = witness ? 'Slice through the contact' : 'Slice through both patches';
    this.separation = separation;
    this.late = late;
    this.frame = sliceFrame(local, picture, picture.parts.map(({ controls }) => middleOf(controls)));
    this.follow = local.patches[0].terms[0].v;
    this.extent = extentOf([0, 1].map((side) => this.section(side, 0)), witness);
    const [before, after] = witness ? beforeAndAfter(picture.range, this.frame, this.extent * picture.scale, late) : [null, null];
    this.ghosts = [['before', before], ['after', after]].filter(([, dt]) => dt !== null)
      .map(([when, dt]) => ({ when, dt, ...this.section(1, dt) }));
  }

  section(side, dt) {
    const { parts, scale } = this.picture;
    return sectionOf(parts[side], this.frame, dt, scale, this.follow);
  }

  /** The patches at t* + dt. */
  move(dt) {
    this.dt = dt;
    this.now = [0, 1].map((side) => this.section(side, dt));
    const { scale } = this.picture;
    const power = Math.floor(Math.log10(scale * this.extent));
    const unit = scale / 10 ** power;
    const label = (name) => (power === 0 ? name : `${name} / 10${superscript(power)}`);
    const lines = (of, key = 'segments') => of[key].map((s) => s.map((x) => x * unit));
    const link = (list, options) => Plot.link(list, { x1: (d) => d[0], y1: (d) => d[1], x2: (d) => d[2], y2: (d) => d[3], strokeLinecap: 'round', clip: true, ...options });
    const dots = (list, options) => Plot.dot(list, { x: (d) => d[0] * unit, y: (d) => d[1] * unit, clip: true, ...options });
    const path = this.ghosts.filter(({ when }) => when === 'before').map((ghost) => this.pathOf(ghost.dt).map((x) => x * unit));
    const domain = [-1, 1].map((sign) => sign * kRim * this.extent * unit);
    this.plot.replaceChildren(Plot.plot({
      style: { fontSize: '12px' }, width: 420, height: 396, marginLeft: 48, marginRight: 12, marginTop: 22, marginBottom: 38,
      x: { label: `${label('in the slice')} →`, domain, ticks: 5 },
      y: { label: `↑ ${label(!this.witness ? 'from patch 1 to patch 2' : this.frame.holdsNormal ? 'contact normal' : 'nearest to the contact normal')}`, domain, ticks: 5, grid: true },
      ariaLabel: 'Slice through the contact',
      marks: [
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
    if (!this.witness) return 'The plane through the middles of both patches, and where it cuts them at the time shown.';
    const touch = this.separation > 0 ? 'At t* both are at the separation that counts as a contact.' : 'At t* both meet in the dot.';
    const after = this.ghosts.find(({ when }) => when === 'after');
    const past = after && pastOf(this.frame, after.dt);
    const dashed = !after ? '' : ` Dashed: ${this.late > 0 ? 'at the time that the method reports' : 'after the contact'}, ${past > 0 ? `${scientific(past)} past patch 1` : 'beside patch 1'}.`;
    const { holdsNormal, holdsMotion } = this.frame;
    const plane = !holdsMotion ? 'the middles of both patches' : holdsNormal ? 'its normal, along the motion of patch 2 as seen from patch 1'
      : 'both patches, along the motion of patch 2 as seen from patch 1';
    return `The plane through the contact and ${plane}. Thick: both cross-sections at the time shown. ${touch} Pale: patch 2 before it.${dashed}`;
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
    return rows;
  }
}
