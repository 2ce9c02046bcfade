"""How soon a fault of each engine is found, beside uniform queries and public samples."""

import pathlib
import random
import resource
import statistics
import tempfile

from engine_tools.asking import hunt_command, json_rows, print_table
from engine_tools.install import ADAPTERS, fail, install, run

# Outcomes that these versions are known to show, asked with options of the adapter: what the scoreboard
# looks for, with so many seeds.
KNOWN_FAULTS = [("rapier", "late", ""), ("rapier", "missed", ""), ("rapier", "late", "mesh=1"),
                ("havok", "late", ""), ("fcl", "missed", ""), ("fcl-bodies", "missed", ""),
                ("bullet", "missed", ""), ("bullet", "late", ""), ("bullet", "missed", "mesh=1"),
                ("physx", "late", "mesh=1"), ("rapier2d", "missed", ""), ("rapier2d", "late", "")]
SEEDS = 5


def used():
    """CPU seconds of all children that have ended."""
    usage = resource.getrusage(resource.RUSAGE_CHILDREN)
    return usage.ru_utime + usage.ru_stime


def seconds_to_first(name, plugin, outcome, seed, arguments, *options):
    """CPU seconds until a find of this outcome is proven and minimised; infinite if there is none."""
    with tempfile.TemporaryDirectory() as finds:
        before = used()
        rows = json_rows(hunt_command(
            name, plugin, arguments, "--corpus", finds, "--until", outcome, "--threads", "1",
            "--seconds", str(arguments.seconds), "--seed", str(seed), *options))
        found = any(row["row"] == "find" and row["outcome"] == outcome for row in rows)
        return used() - before if found else float("inf")


def seconds_to_first_sample(name, plugin, outcome, seed, arguments):
    """The same among the queries of CSV files, in an order that the seed draws."""
    files = sorted(pathlib.Path(arguments.samples).rglob("*.csv"))
    random.Random(seed).shuffle(files)
    named = ["--plugin", f"{name}={plugin}", "--threads", "1"]
    with tempfile.TemporaryDirectory() as folder:
        before, proven = used(), pathlib.Path(folder) / "proven.jsonl"
        for file in files:
            if used() - before > arguments.seconds:
                break
            run([arguments.program, "prove", file, "-o", proven, "--threads", "1"])
            for row in json_rows([arguments.program, "replay", proven, *named, "--methods",
                                  f"plugin:{name}", "--expect", "correct", "--json"], accepted=(0, 1)):
                if row.get("got") == outcome:
                    place = int(row["case"].rpartition(":")[2]) - 1
                    found = pathlib.Path(folder) / "found.jsonl"
                    found.write_text(proven.read_text().splitlines()[place] + "\n")
                    run([arguments.program, "minimize", found, *named[:2], "--method", f"plugin:{name}",
                         "-o", pathlib.Path(folder) / "small.json"])
                    return used() - before
    return float("inf")


def takes_features(name):
    """Whether an engine is asked of vertices, faces and edges, as public samples are."""
    adapter = ADAPTERS / name / "adapter.cpp"
    return adapter.exists() and "linear_pairs" in adapter.read_text()


def scoreboard(arguments):
    if arguments.samples and not any(pathlib.Path(arguments.samples).rglob("*.csv")):
        fail(f"--samples: {arguments.samples} has no .csv file")
    rows, columns = [], ["ours", "uniform"] + ["samples"] * bool(arguments.samples)
    for name, outcome, asked_with in KNOWN_FAULTS:
        if arguments.engines and name not in arguments.engines:
            continue
        _, plugin, version = install(name, "", arguments)
        plugin = ":".join(filter(None, [plugin, asked_with]))
        row = {"engine": " ".join(filter(None, [name, version, asked_with])), "fault": outcome}
        for column in columns:
            if column == "samples" and not takes_features(name):
                row.update({column: "-", column + " found": "-"})
                continue
            seeds = range(1, SEEDS + 1)
            if column == "samples":
                runs = [seconds_to_first_sample(name, plugin, outcome, seed, arguments)
                        for seed in seeds]
            else:
                options = ["--uniform"] if column == "uniform" else []
                runs = [seconds_to_first(name, plugin, outcome, seed, arguments, *options)
                        for seed in seeds]
            median = statistics.median(runs)
            row[column] = (f"{median:.2g} s" if median < float("inf") else "none")
            row[column + " found"] = f"{sum(r < float('inf') for r in runs)} of {SEEDS}"
        rows.append(row)
    print_table(["engine", "fault"] + [c + end for c in columns for end in ("", " found")], rows)
    return 0
