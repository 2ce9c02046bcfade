#!/usr/bin/env python3
"""The records of bench/hunt_by_shape.sh, one JSON object a line.

by_shape_records.py hunted|table RECORDS METHOD SECONDS SEED

hunted: prints the shapes that were hunted with these. table: prints what all of these came to. A last
line that was being written when its writer ended is cut off. A line that is no record is an error.
"""
import json
import os
import sys

COUNTS = ("n", "undecided", "missed", "late", "mutants", "lost_mutants")
START = b'{"shape":"'


def parsed(line):
    """The record of a line; None if it is none."""
    try:
        record = json.loads(line)
        sound = isinstance(record["shape"], str) and isinstance(record["method"], str)
        sound = sound and isinstance(record["cells"], list) and record["seconds"] > 0 and record["seed"] >= 0
        # A record without it says at least how long the drawn queries took, which is without the mutants.
        record.setdefault("cpu_seconds", sum(cell["cpu_seconds"] for cell in record["cells"]))
        sound = sound and record["cpu_seconds"] >= 0
        for cell in record["cells"]:
            sound = sound and sum(cell[count] for count in COUNTS) >= 0
            sound = sound and (cell["margin_ulps"] is None or cell["margin_ulps"] >= 0)
    except (ValueError, KeyError, TypeError):
        return None
    return record if sound else None


def read(path):
    with open(path, "r+b") as file:
        lines = file.read().splitlines(keepends=True)
        records = [parsed(line) for line in lines]
        if lines and not lines[-1].endswith(b"\n"):
            if records[-1]:
                file.write(b"\n")
            elif lines[-1].startswith(START[: len(lines[-1])]):
                print(f"{path}:{len(lines)}: is not whole and left out", file=sys.stderr)
                file.seek(-len(lines[-1]), os.SEEK_END)
                file.truncate()
                records.pop()
    if None in records:
        print(f"{path}:{records.index(None) + 1}: is no record of a hunt by shape", file=sys.stderr)
        sys.exit(2)
    return records


def print_table(records):
    tallies = {}
    for record in records:
        for name in (record["shape"], "all"):
            t = tallies.setdefault(name, dict.fromkeys(COUNTS, 0) | {"margin": None, "cpu": 0})
            t["cpu"] += record["cpu_seconds"]
            for cell in record["cells"]:
                for count in COUNTS:
                    t[count] += cell[count]
                margins = [m for m in (t["margin"], cell["margin_ulps"]) if m is not None]
                t["margin"] = min(margins, default=None)
    print("| shapes | CPU s | queries | undecided | missed or late | mutants traced | lost | smallest margin, ulps |")
    print("|---|---|---|---|---|---|---|---|")
    for name, t in sorted(tallies.items(), key=lambda item: item[0] == "all"):
        counts = f"{t['n']:,} | {t['undecided']:,} | {t['missed'] + t['late']} | {t['mutants']:,} | {t['lost_mutants']:,}"
        print(f"| {name} | {t['cpu']:,.0f} | {counts} | {t['margin']} |")


def main(what, path, method, seconds, seed):
    asked = (method, float(seconds), int(seed))
    # Each shape once, though two hunts at a time may have written it.
    records = {r["shape"]: r for r in read(path) if (r["method"], r["seconds"], r["seed"]) == asked}
    if what == "table":
        print_table(records.values())
    else:
        for shape in records:
            print(shape)


try:
    main(*sys.argv[1:])
except OSError as error:
    print(f"{error.filename}: {error.strerror}", file=sys.stderr)
    sys.exit(2)
