#!/usr/bin/env python3
"""A plug-in by lines of JSON: vertex-face and edge-edge queries by inclusion of boxes.

The gap between two linear patches is linear in each of t and the two parameters, so that over a box
of them it lies within the box of its values at the eight corners. Boxes that may hold a contact are
split until they are small. In plain floating point: the box is widened for rounding by a guess.
"""

import heapq
import itertools
import json
import sys

PRECISION = 1e-6  # of parameters
GUARD = 1e-14     # relative, for rounding


def gap(patches, t, a, b):
    """The vector between the points at parameters a and b: both of the face, or one of each edge."""
    first, second = ([[p + t * v for p, v in zip(*row)]
                      for row in zip(patch["positions"], patch["velocities"])] for patch in patches)
    if patches[0]["shape"] == "point":
        w, v, u = second
        return [p - (q + a * (r - q) + b * (s - q)) for p, q, r, s in zip(first[0], w, u, v)]
    return [(p + a * (q - p)) - (r + b * (s - r))
            for p, q, r, s in zip(first[0], first[1], second[0], second[1])]


def may_touch(patches, box, guard):
    corners = [gap(patches, *corner) for corner in itertools.product(*box)]
    return all(min(x) <= guard and max(x) >= -guard for x in zip(*corners))


def answer(query):
    patches, t_max = query["patches"], query["t_max"]
    is_face = patches[0]["shape"] == "point"
    numbers = [abs(x) for patch in patches for points in (patch["positions"], patch["velocities"])
               for point in points for x in point]
    guard = GUARD * max(numbers) * (1 + t_max)
    queue, looked = [((0, t_max), (0, 1), (0, 1))], 0
    while queue:
        box = heapq.heappop(queue)  # the earliest first
        looked += 1
        if looked > min(query["max_iterations"], 20000):
            return {"verdict": "inconclusive", "iterations": looked}
        if is_face and box[1][0] + box[2][0] > 1 or not may_touch(patches, box, guard):
            continue
        widths = [(hi - lo) / (t_max if k == 0 and t_max > 0 else 1)
                  for k, (lo, hi) in enumerate(box)]
        if max(widths) <= PRECISION:
            where = [[0, 0], [box[1][0], box[2][0]]] if is_face else [[box[1][0], 0], [box[2][0], 0]]
            return {"verdict": "hit", "toi": list(box[0]), "uv": where, "iterations": looked}
        k = widths.index(max(widths))
        middle = (box[k][0] + box[k][1]) / 2
        for half in ((box[k][0], middle), (middle, box[k][1])):
            heapq.heappush(queue, box[:k] + (half,) + box[k + 1:])
    return {"verdict": "miss", "iterations": looked}


def pair(first, second):
    return [{"shape": first, "max_degree": 1}, {"shape": second, "max_degree": 1}]


DESCRIPTION = {"protocol": 1, "name": "boxes, in Python", "version": "1.0", "conservative": True,
               "accepts": [pair("point", "triangle"), pair("curve", "curve")]}

for line in sys.stdin:
    asked = json.loads(line)
    reply = DESCRIPTION if asked["ask"] == "describe" else {"id": asked["id"], **answer(asked)}
    print(json.dumps(reply), flush=True)
