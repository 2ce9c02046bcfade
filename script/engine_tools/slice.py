#!/usr/bin/env python3
"""Draws a find of two bodies as a plane slice: slice.py FIND [--late TIME] [--plane] -o FILE.svg

The slice is at the instant of the deepest overlap; of a late answer, at the TIME that the engine gave.
Its plane holds the direction of the depth, and the relative motion; or an edge, where that one meets
the overlap in a point alone. The depth is as `ccdfuzz query` has it: moved by less, whatever way, the
bodies would still touch in the time that the answer overlooks. Coordinates are rounded doubles: a
picture proves nothing. Bodies that turn or spin, and patches, are not drawn.
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


class Body:
    """Convex parts (a hull, or the faces of a mesh), a radius, and one velocity."""

    def __init__(self, patch):
        if patch["shape"] != "hull" or "turn" in patch or "spin" in patch:
            raise ValueError("only bodies are drawn, and none that turns or spins")
        points = [tuple(map(number, p)) for p in patch["positions"]]
        faces = patch.get("faces", [range(len(points))])
        self.parts = [[points[i] for i in face] for face in faces]
        self.radius = number(patch.get("radius", 0))
        self.velocity = tuple(map(number, patch["velocities"][0]))

    def at(self, t):
        return [[add(p, self.velocity, t) for p in part] for part in self.parts]


class Slice:
    """Both bodies of a find in the plane of a picture. Its origin is the middle of the overlap, its x
    axis along the motion, and its y axis along the direction of the depth."""

    def __init__(self, find, late, plane):
        one, other = sorted(map(Body, find["patches"]), key=lambda body: not any(body.velocity))
        reach = one.radius + other.radius
        motion = add(one.velocity, other.velocity, -1)
        until = number(find["t_max"]) if late is None else late

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
        self.time = low
        self.bodies = [(body.at(low), body.radius) for body in (one, other)]
        near = [(parts[k], radius) for (parts, radius), k in zip(self.bodies, (i, j))]
        # The plane along the motion; along an edge where that one meets the overlap in a point alone.
        best, visible = (-math.inf,), self.depth / 1000
        for way in filter(any, [motion, *edges, *AXES]):
            if best[0] <= visible and abs(dot(unit(way), up)) < 1 - 1e-9:
                across = unit(add(way, up, -dot(way, up)))
                found = self.place(near, (across, up, cross(across, up)))
                best = found if found[0] > best[0] + visible else best
        _, self.axes, self.origin = best
        self.arrow = dot(self.axes[0], motion), dot(self.axes[1], motion)
        self.outlines = [[section(part, radius, self.origin, *self.axes) for part in parts]
                         for parts, radius in self.bodies]
        self.overlaps = [overlap(a, b) for a in self.outlines[0] for b in self.outlines[1] if a and b]

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
            lines.append(f'<polygon class="{name}" points="{text}"/>' if len(shown) > 1 else
                         f'<circle class="{name}" cx="{shown[0][0]:.1f}" cy="{shown[0][1]:.1f}" r="3"/>')
    length = math.hypot(*drawn.arrow)
    if length > 0:
        x, y = (SIDE / 8 * c / length for c in drawn.arrow)
        lines.append(f'<path class="way" d="M{60 - x:.1f} {SIDE - 60 + y:.1f}l{2 * x:.1f} {-2 * y:.1f}" '
                     'marker-end="url(#tip)"/>')
    lines.append("</svg>")
    step = 10 ** math.floor(math.log10(half))
    step *= next(k for k in (5, 2, 1, 0.5) if half / (k * step) >= 2)
    for k in range(-int(half / step), int(half / step) + 1):
        at, text = SIDE / 2 * (1 + k * step / half), f"{k * step:.6g}".replace("-", "−")
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
            f"They pass {drawn.depth:.3g} deep through each other. Up is the shortest way out."]
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
