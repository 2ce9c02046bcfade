"""Plane sections of convex bodies, and how deep they overlap, in doubles."""

import math

AXES = [(1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)]
ROUND = 360  # directions in which the outline of a round body is computed


def add(a, b, s=1):
    return tuple(x + s * y for x, y in zip(a, b))


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def unit(v):
    length = math.hypot(*v)
    return tuple(x / length for x in v) if length > 0 else None


def directions(points):
    return [add(p, q, -1) for i, p in enumerate(points) for q in points[:i] if p != q]


def depth_of(a, b, reach, edges, plane):
    """(depth, direction): the least way by which the hull a, moved along the unit direction, leaves the
    hull b, both rounded by radii of this sum. Below 0, the distance. One direction of least way is
    square to a face of one, to an edge of each, or to both where they are nearest: all are tried. In
    the plane z = 0, those in it."""
    least = (math.inf, None)
    all_edges = AXES + edges  # of lines through each other's middle any way square to them is one
    normals = AXES + [cross(e, f) for i, e in enumerate(all_edges) for f in all_edges[:i]]
    for p in a:
        for q in b:
            gap = add(p, q, -1)
            normals.append(gap)
            normals += [add(gap, e, -dot(gap, e) / dot(e, e)) for e in edges]
    for n in filter(None, map(unit, normals)):
        if plane and n[2] != 0:
            continue
        heights, others = [dot(n, p) for p in a], [dot(n, q) for q in b]
        least = min(least, (max(others) - min(heights) + reach, n),
                    (max(heights) - min(others) + reach, tuple(-x for x in n)))
    return least


def section(points, radius, origin, u, v, w, steps=ROUND):
    """The polygon in which the plane through the origin, with axes u and v and normal w, cuts a hull
    that is rounded by the radius; empty where it does not."""
    flat = [(dot(u, d), dot(v, d), dot(w, d)) for d in (add(p, origin, -1) for p in points)]
    if radius == 0:
        size = max(abs(x) for p in [origin, *points] for x in p)
        zero = 1e-12 * size  # rounded coordinates are this near to a plane that they are in
        cut = [p[:2] for p in flat if abs(p[2]) <= zero]
        cut += [tuple((p[k] * q[2] - q[k] * p[2]) / (q[2] - p[2]) for k in (0, 1))
                for i, p in enumerate(flat) for q in flat[:i]
                if min(abs(p[2]), abs(q[2])) > zero and p[2] * q[2] < 0]
        return hull(cut, zero)
    if min(p[2] for p in flat) >= radius or max(p[2] for p in flat) <= -radius:
        return []
    supports = []
    for i in range(steps):
        c, s = math.cos(2 * math.pi * i / steps), math.sin(2 * math.pi * i / steps)

        def height(slope):  # of the body along (c, s, slope), which bounds the section
            return max(p[0] * c + p[1] * s + p[2] * slope for p in flat) + radius * math.hypot(1, slope)
        low, high = -1e3, 1e3  # the height is convex in the slope
        for _ in range(90):
            one, other = (2 * low + high) / 3, (low + 2 * high) / 3
            low, high = (low, other) if height(one) < height(other) else (one, high)
        supports.append((c, s, height(low)))
    step = math.sin(2 * math.pi / steps)
    return [((h * t - g * s) / step, (g * c - h * d) / step)
            for (c, s, h), (d, t, g) in zip(supports, supports[1:] + supports[:1])]


def hull(points, zero):
    """Counter-clockwise; one or two points where there is no area."""
    points = sorted(set(points))

    def chain(order):
        kept = []
        for p in order:
            while len(kept) > 1 and turn(kept[-2], kept[-1], p) <= zero * math.dist(kept[-2], p):
                kept.pop()
            kept.append(p)
        return kept[:-1]
    return chain(points) + chain(points[::-1]) if len(points) > 1 else points


def turn(a, b, c):
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def overlap(one, other):
    """What two convex polygons have in common; either may be a point or a segment."""
    if len(one) > len(other):
        one, other = other, one
    size = max((abs(x) for p in one + other for x in p), default=0)
    sides = [(p, q) for p, q in zip(other, other[1:] + other[:1]) if p != q]
    if len(other) == 2:  # its ends, too
        p, q = other
        across = (p[1] - q[1], q[0] - p[0])
        sides += [(q, (q[0] + across[0], q[1] + across[1])), (p, (p[0] - across[0], p[1] - across[1]))]
    kept = list(one)
    for p, q in sides:
        inside = [turn(p, q, x) / math.dist(p, q) + 1e-9 * size for x in kept]  # no picture shows it
        pairs = list(zip(kept, inside))
        kept = []
        for (x, d), (y, e) in zip(pairs[-1:] + pairs[:-1], pairs):
            if d * e < 0:
                kept.append((x[0] + (y[0] - x[0]) * d / (d - e), x[1] + (y[1] - x[1]) * d / (d - e)))
            if e >= 0:
                kept.append(y)
    return kept if len(other) > 1 or one == other else []


def area(polygon):
    return sum(turn((0, 0), p, q) for p, q in zip(polygon, polygon[1:] + polygon[:1])) / 2


def size_of(one, other):
    """The root of the area that two sections have in common, or its length; less their distance."""
    red = overlap(one, other)
    if red:
        return math.sqrt(max(area(red), 0)) or max(math.dist(p, q) for p in red for q in red)
    return -min((to_segment(p, q, r) for a, b in ((one, other), (other, one)) for p in a
                 for q, r in zip(b, b[1:] + b[:1])), default=math.inf)


def to_segment(p, q, r):
    way, at = (r[0] - q[0], r[1] - q[1]), (p[0] - q[0], p[1] - q[1])
    share = min(max(dot(way, at) / (dot(way, way) or 1), 0), 1)
    return math.dist(at, (share * way[0], share * way[1]))
