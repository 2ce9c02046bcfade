#!/usr/bin/env python3
"""Draws a find of two bodies as a plane slice: slice.py FIND [--late TIME] [--plane] -o FILE.svg

The slice is at the instant of the deepest overlap; of a late answer, at the TIME that the engine gave.
Its plane holds the direction of the depth, and the relative motion; or an edge, where that one meets
the overlap in a point alone. The depth is as `ccdfuzz query` has it: moved by less, whatever way, the
bodies would still touch in the time that the answer overlooks. That of bodies that turn or spin, and of
features whose points move each on its own, is what the find says: it is a lower bound. Coordinates are
rounded doubles: a picture proves nothing. Curved, rational and trimmed patches are not drawn.
"""

import argparse
import html
import json
import math
import pathlib
import sys
sys.dont_write_bytecode = True
from sections import AXES, ROUND, add, cross, depth_of, directions, dot, overlap, section, size_of, unit

SIDE = 340  # of a panel, in pixels


def number(x):
    return float.fromhex(x) if isinstance(x, str) else float(x)


def rotation(patch, t):
    """Where a body has its points about its centre at a time t: a function of such a point."""
    if "spin" in patch:
        axis = [number(x) for x in patch["spin"]["velocity"]]
        half = math.hypot(*axis) * t / 2
        q = [math.cos(half), *(math.sin(half) * x / (math.hypot(*axis) or 1) for x in axis)]
    else:
        q = [(1 - t) * number(x) + t * number(y) for x, y in zip(patch["turn"]["from"], patch["turn"]["to"])]
        if len(q) == 2:  # cosine and sine: a quaternion has those of half the angle
            q = [math.hypot(*q) + q[0], 0, 0, q[1]]
    w, u = q[0] / math.hypot(*q), tuple(x / math.hypot(*q) for x in q[1:])
    return lambda p: add(add(p, cross(u, p), 2 * w), cross(u, cross(u, p)), 2)


class Body:
    """Convex parts (a hull, a feature, or the faces of a mesh), a radius, and how its points move."""

    def __init__(self, patch):
        is_drawn = patch["shape"] in ("hull", "point") or patch.get("degree") == 1 and patch["shape"] != "tensor"
        if not is_drawn or {"weights", "trim", "ends"} & set(patch):
            raise ValueError("only bodies, vertices, edges and faces are drawn")
        points = [tuple(map(number, p)) for p in patch["positions"]]
        velocities = [tuple(map(number, v)) for v in patch["velocities"]]
        self.moving = list(zip(points, velocities * (len(points) if len(velocities) == 1 else 1)))
        self.faces = patch.get("faces", [range(len(points))])
        self.radius = number(patch.get("radius", 0))
        self.turning = patch if "turn" in patch or "spin" in patch else None
        self.velocity = velocities[0]
        self.is_rigid = self.turning is None and len(set(velocities)) == 1
        self.is_still = self.turning is None and not any(map(any, velocities))
        self.parts = self.at(0)

    def at(self, t):
        points = [add(p, v, t) for p, v in self.moving]
        if self.turning:
            turned, of = rotation(self.turning, t), self.turning.get("turn") or self.turning["spin"]
            centre = tuple(map(number, of.get("centre", (0, 0, 0))))
            points = [add(add(centre, turned(add(p, centre, -1))), v, t) for p, v in self.moving]
        return [[points[i] for i in face] for face in self.faces]

    def way(self, t):
        """The velocity of the middle of its points, by a difference where it is none for all."""
        if self.is_rigid:
            return self.velocity
        step = 2.0 ** -20
        one, two = ([sum(c) / len(part) for c in zip(*part)] for part in (self.at(t)[0], self.at(t + step)[0]))
        return tuple((y - x) / step for x, y in zip(one, two))


class Slice:
    """Both bodies of a find in the plane of a picture. Its origin is the middle of the overlap, its x
    axis along the motion, and its y axis along the direction of the depth."""

    def __init__(self, find, late, plane):
        one, other = sorted(map(Body, find["patches"]), key=lambda body: body.is_still)
        reach = one.radius + other.radius
        until = number(find["t_max"]) if late is None else late
        if one.is_rigid and other.is_rigid:
            low, i, j, up = self.of_rigid(one, other, reach, until, late, plane)
        else:
            low, i, j, up = self.of_others(one, other, reach, until, late, plane)
            self.depth = find["origin"]["depth"]
        self.is_bound = not (one.is_rigid and other.is_rigid)
        motion = add(one.way(low), other.way(low), -1)
        self.time = low
        self.bodies = [(body.at(low), body.radius) for body in (one, other)]
        edges = directions(self.bodies[0][0][i]) + directions(self.bodies[1][0][j])
        near = [(parts[k], radius) for (parts, radius), k in zip(self.bodies, (i, j))]
        # The plane along the motion; along an edge where that one meets the overlap in a point alone.
        best, visible = (-math.inf,), self.depth / 1000
        ways = [motion, *edges, *AXES]
        if all(len(part) == 2 and radius == 0 for part, radius in near):
            ways = [*edges, *ways]  # of two segments, one is in the plane
        for way in filter(any, ways):
            if best[0] <= visible and abs(dot(unit(way), up)) < 1 - 1e-9:
                across = unit(add(way, up, -dot(way, up)))
                found = self.place(near, (across, up, cross(across, up)))
                best = found if found[0] > best[0] + visible else best
        _, self.axes, self.origin = best
        self.arrow = dot(self.axes[0], motion), dot(self.axes[1], motion)
        self.outlines = [[section(part, radius, self.origin, *self.axes) for part in parts]
                         for parts, radius in self.bodies]
        self.overlaps = [overlap(a, b) for a in self.outlines[0] for b in self.outlines[1] if a and b]

    def of_rigid(self, one, other, reach, until, late, plane):
        """The time, the part of each and the direction of the depth, which is that of a swept hull."""
        motion = add(one.velocity, other.velocity, -1)

        def deepest(a, b):
            swept = a + [add(p, motion, until) for p in a]
            edges = directions(a) + directions(b) + [motion] * any(motion)
            return depth_of(swept, b, reach, edges, plane)
        (self.depth, up), i, j = max((deepest(a, b), i, j) for i, a in enumerate(one.parts)
                                     for j, b in enumerate(other.parts))
        edges = directions(one.parts[i]) + directions(other.parts[j])

        def depth_at(t):
            return depth_of(one.at(t)[i], other.at(t)[j], reach, edges, plane)[0]
        low, high = (0, until) if late is None else (late, late)
        for _ in range(100 if late is None else 0):  # the depth at one time is concave
            first, last = (2 * low + high) / 3, (low + 2 * high) / 3
            low, high = (low, last) if depth_at(first) >= depth_at(last) else (first, high)
        return low, i, j, up

    def of_others(self, one, other, reach, until, late, plane):
        """The same at the time of the deepest overlap; it is looked for where it is deepest of some."""
        def deepest(t):
            a, b = one.at(t)[0], other.at(t)[0]
            return depth_of(a, b, reach, directions(a) + directions(b), plane)
        times = [until * k / 256 for k in range(257)] if late is None else [late]
        k = max(range(len(times)), key=lambda k: deepest(times[k]))
        low, high = times[max(k - 1, 0)], times[min(k + 1, len(times) - 1)]
        for _ in range(100 if late is None else 0):
            first, last = (2 * low + high) / 3, (low + 2 * high) / 3
            low, high = (low, last) if deepest(first) >= deepest(last) else (first, high)
        best = max((times[k], low), key=deepest)
        return best, 0, 0, deepest(best)[1]

    def place(self, near, axes):
        """How much of the overlap is in the best of the planes with these axes, the axes, and the
        middle of what is there. The root of an area, and less the distance, are concave along the
        normal, so that a search in thirds finds the best."""
        spans = [[side(dot(axes[2], p) for p in part) + sign * radius
                  for side, sign in ((min, -1), (max, 1))] for part, radius in near]
        low, high = max(s[0] for s in spans), min(s[1] for s in spans)

        def at(offset, steps=24):
            origin = tuple(offset * x for x in axes[2])
            cuts = [section(part, radius, origin, *axes, steps) for part, radius in near]
            return size_of(*cuts), overlap(*cuts), origin
        best = max((at(offset)[0], offset) for offset in (low, high))
        for _ in range(100):
            first, last = (2 * low + high) / 3, (low + 2 * high) / 3
            one, other = (at(first)[0], first), (at(last)[0], last)
            best = max(best, one, other)
            low, high = (low, last) if one[0] >= other[0] else (first, high)
        size, red, origin = at(best[1], ROUND)
        if not red:
            raise ValueError("the bodies do not overlap at that time")
        middle = [(min(p[k] for p in red) + max(p[k] for p in red)) / 2 for k in (0, 1)]
        return size, axes, add(add(origin, axes[0], middle[0]), axes[1], middle[1])


def words(body):
    parts, radius = body
    if len(parts) > 1:
        return f"mesh of {len(parts)} triangles"
    count = len(parts[0])
    name = ["point", "segment", "triangle"][count - 1] if count < 4 else f"hull of {count} points"
    if radius > 0:
        name = ["ball", "capsule"][count - 1] if count < 3 else "rounded " + name
    return name + (f" of radius {radius:g}" if radius > 0 else "")


def panel(left, title, drawn, half):
    """A square part of the slice: half of its edges is in units of length."""
    def pixels(polygon):
        window = [(1.1 * half * x, 1.1 * half * y) for x, y in ((-1, -1), (1, -1), (1, 1), (-1, 1))]
        inside = overlap(polygon, window) if polygon else []
        scaled = [(SIDE / 2 * (1 + x / half), SIDE / 2 * (1 - y / half)) for x, y in inside]
        kept = []
        for p in scaled:  # of an arc, not all points
            if len(scaled) < 20 or not kept or math.dist(p, kept[-1]) > 2:
                kept.append(p)
        return kept
    lines = [f'<text x="{left + SIDE / 2:g}" y="90" text-anchor="middle">{title}</text>',
             f'<svg x="{left}" y="96" width="{SIDE}" height="{SIDE}">']
    for name, polygons in zip(("one", "other", "overlap"), (*drawn.outlines, drawn.overlaps)):
        for shown in filter(None, map(pixels, polygons)):
            text = " ".join(f"{x:.1f},{y:.1f}" for x, y in shown)
            lines.append(f'<polygon class="{name}" points="{text}"/>' if math.dist(min(shown), max(shown)) > 0.2 else
                         f'<circle class="{name}" cx="{shown[0][0]:.1f}" cy="{shown[0][1]:.1f}" r="3"/>')
    length = math.hypot(*drawn.arrow)
    if length > 0:
        x, y = (SIDE / 8 * c / length for c in drawn.arrow)
        lines.append(f'<path class="way" d="M{60 - x:.1f} {SIDE - 60 + y:.1f}l{2 * x:.1f} {-2 * y:.1f}" '
                     'marker-end="url(#tip)"/>')
    lines.append("</svg>")
    power = math.floor(math.log10(half))
    step = 10 ** power
    step *= next(k for k in (5, 2, 1, 0.5) if half / (k * step) >= 2)
    for k in range(-int(half / step), int(half / step) + 1):
        text = f"{k * step:.6g}" if step >= 1e-4 or k == 0 else f"{k * step / 10 ** power:g}e{power}"
        at, text = SIDE / 2 * (1 + k * step / half), text.replace("-", "−")
        lines += [f'<path class="axis" d="M{left + at:.1f} {96 + SIDE}v5M{left} {96 + SIDE - at:.1f}h-5"/>',
                  f'<text class="n" x="{left + at:.1f}" y="{114 + SIDE}" text-anchor="middle">{text}</text>',
                  f'<text class="n" x="{left - 8}" y="{100 + SIDE - at:.1f}" text-anchor="end">{text}</text>']
    lines.append(f'<rect class="axis" x="{left}" y="96" width="{SIDE}" height="{SIDE}"/>')
    return lines


def svg(find, command, late, plane):
    drawn = Slice(find, late, plane)
    points = [p for outlines in drawn.outlines for polygon in outlines for p in polygon]
    whole = 1.1 * max(abs(x) for p in points for x in p)
    red = [abs(x) for polygon in drawn.overlaps for p in polygon for x in p]
    near = min(whole, 4 * max(red + [drawn.depth / 2]))
    engine = next(iter(find["expect"]), "an engine").removeprefix("plugin:")
    said = "no contact" if late is None else f"a contact at {late:g}"
    first, second = map(words, drawn.bodies)
    places = [(60, "both bodies in the slice", whole), (SIDE + 140, "the overlap from near", near)]
    panels = [panel(left, title, drawn, half) for left, title, half in places[:1 if near > whole / 2 else 2]]
    told = [f'{engine} {find["origin"]["version"]} reports {said}. At t = {drawn.time:.5g} of '
            f'{number(find["t_max"]):g} the bodies overlap where it is red.',
            f"Blue: a {first}, which moves along the arrow. Grey: a {second}.",
            f"They pass {'at least ' * drawn.is_bound}{drawn.depth:.3g} deep through each other. "
            "Up is the shortest way out."]
    width, height = 2 * SIDE + 170, SIDE + 120
    lines = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}">',
             f"<desc>{html.escape(command)}</desc>",
             "<style>text{font:13px sans-serif}.n{font-size:11px}.one{fill:#3b82f680;stroke:#1d4ed8}"
             ".other{fill:#9ca3af80;stroke:#374151}.overlap{fill:#dc2626;stroke:#dc2626;stroke-width:3;"
             "stroke-linejoin:round;stroke-linecap:round}.axis{fill:none;stroke:#000}"
             ".way{stroke:#1d4ed8;stroke-width:2}</style>",
             '<defs><marker id="tip" orient="auto" markerWidth="8" markerHeight="8" refY="3">'
             '<path d="M0 0L6 3L0 6z" fill="#1d4ed8"/></marker></defs>',
             f'<rect width="{width}" height="{height}" fill="#fff"/>',
             *(f'<text x="20" y="{22 + 20 * i}">{html.escape(text, quote=False)}</text>' for i, text in enumerate(told)),
             *sum(panels, []), "</svg>"]
    return "\n".join(lines) + "\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("find", type=pathlib.Path)
    parser.add_argument("--late", type=float, metavar="TIME", help="what the engine answers")
    parser.add_argument("--plane", action="store_true", help="of an engine in the plane z = 0")
    parser.add_argument("-o", "--output", type=pathlib.Path, required=True)
    arguments = parser.parse_args()
    command = " ".join(["script/engine_tools/slice.py", str(arguments.find), *(
        [] if arguments.late is None else ["--late", repr(arguments.late)]), *["--plane"] * arguments.plane])
    try:
        find = json.loads(arguments.find.read_text())
        arguments.output.write_text(svg(find, command, arguments.late, arguments.plane))
    except (OSError, ValueError, LookupError, TypeError, AttributeError) as error:
        parser.error(f"{arguments.find}: {error}")


if __name__ == "__main__":
    main()
