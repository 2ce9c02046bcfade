"""Hunts an engine, and makes the rows of the tables."""

import json

from engine_tools.asking import hunt_command, json_rows, rows_and_peak
from engine_tools.install import ADAPTERS

# What was found; and what answers cost, beside those of a method of ours to the same queries.
COLUMNS = ["engine", "version", "queries", "missed", "late", "false hit", "gave up", "errors", "finds",
           "deepest", "of its own"]
COSTS = ["engine", "version", "mean", "p99.9", "memory", "beside", "its mean", "its p99.9"]

# What a row of a hunt calls the columns.
KEYS = {"queries": "n", "missed": "missed", "late": "late", "false hit": "false_positive",
        "gave up": "undecided", "errors": "error"}


def finds_folder(folder, arguments):
    return folder / "-".join(["finds", *arguments.options.split(":")] if arguments.options else ["finds"])


def built_in(plugin, arguments):
    """The method of ours that answers what an engine does: of bodies, only the oracle does."""
    takes = json_rows([arguments.program, "methods", plugin, "--json"])[0]["takes"]
    return "oracle" if "bodies" in takes else "tdibm-c"


def duration(seconds):
    for unit, name in ((1, "s"), (1e-3, "ms"), (1e-6, "us")):
        if seconds >= unit:
            break
    return f"{seconds / unit:.3g} {name}"


def costs(cells, beside, peak):
    """The columns of costs. A p99.9 is that of the slowest contact class: of all queries, no more
    than one in 1000 took longer. `peak` is in bytes."""
    def of(prefix):
        known = [(cell["n"], cell[prefix + "mean_seconds"], cell[prefix + "p999_seconds"])
                 for cell in cells if cell["n"] > 0 and prefix + "mean_seconds" in cell]
        if not known:
            return "-", "-"
        mean = sum(n * seconds for n, seconds, _ in known) / sum(n for n, _, _ in known)
        return duration(mean), duration(max(slow for _, _, slow in known))
    return dict(zip(COSTS[2:], [*of(""), f"{peak / 2**20:.0f} MiB", beside, *of("beside_")]))


def deepest(finds):
    """How deep the deepest of the asked finds is, and in the engine's own tolerance. Where that is a
    time, how late the latest is in it."""
    depth = max((find.get("depth", 0) for find in finds), default=0)
    own, kind = max(((find.get(what, 0) / find[tolerance], kind) for find in finds
                     for what, tolerance, kind in (("depth", "depth_tolerance", "x"),
                                                   ("late_by", "time_tolerance", "x late"))
                     if find.get(tolerance, 0) > 0 and what in find), default=(0, ""))
    return {"deepest": f"{depth:.2g}" if depth > 0 else "-",
            "of its own": f"{float(f'{own:.2g}'):g} {kind}" if own > 0 else "-"}


def hunt(name, folder, plugin, arguments):
    """The row of an engine, of the hunt's own rows, and the names of the errors that it met."""
    length = (["--cases", str(arguments.cases)] if arguments.cases is not None
              else ["--seconds", str(arguments.seconds)])
    beside = built_in(plugin, arguments)
    row, paths, cells, errors = dict.fromkeys(KEYS, 0), set(), [], set()
    rows, peak = rows_and_peak(hunt_command(
        name, plugin, arguments, "--corpus", finds_folder(folder, arguments), "--seed", arguments.seed,
        "--beside", beside, *length))
    for line in rows:
        if line["row"] == "cell":
            cells.append(line)
            for column, key in KEYS.items():
                row[column] += line[key]
        elif line["row"] == "find" and line["path"]:
            paths.add(line["path"])
            if line["outcome"] == "error":
                errors.add(line["cause"])
    # A hunt measures new finds alone, and not those that an earlier one has stored.
    finds = json_rows([arguments.program, "query", *sorted(paths), "--plugin", f"{name}={plugin}",
                       "--methods", f"plugin:{name}", "--json"]) if paths else []
    return ({**row, "finds": len(paths), **deepest(finds), **costs(cells, beside, peak)},
            ", ".join(sorted(errors)))


def promise(name):
    return f"promise of {name}: {json.loads((ADAPTERS / name / 'promise.json').read_text())}"
