"""What changed from one version of an engine to another."""

import json
import pathlib

from engine_tools.asking import outcomes
from engine_tools.hunting import finds_folder
from engine_tools.install import ENGINES, ROOT, TAKES, fail, install, run

KEPT = ROOT / "corpus/engines"
WRONG = {"missed", "late", "false_positive"}  # an error may be the adapter's


def what_changed(name, hunted, arguments):
    """What differs between hunts of two versions, in words. Each is a row with the engine's folder of
    finds and its plug-in; the finds of both are put to both, and so are the kept ones."""
    options = f":{TAKES[name]}" if name in TAKES and not arguments.options else ""
    folders = [(finds, "") for _, finds, _ in hunted] + [(KEPT / name, options)]
    before, after = ({find: got for finds, more in folders if any(finds.glob("*.json"))
                      for find, got in outcomes(name, plugin + more, finds, arguments).items()}
                     for _, _, plugin in hunted)
    old, new = (row["version"] for row, _, _ in hunted)
    both = [find for find in before if before[find] in WRONG and after.get(find) in WRONG]
    alone = [(version, sorted({pathlib.Path(find).stem for find in shown
                               if shown[find] in WRONG and others.get(find) == "correct"}))
             for version, shown, others in ((old, before, after), (new, after, before))]
    words = [f"{len(both)} fail in both"]
    for version, finds in alone:
        some = f" ({', '.join(finds[:3])}{', …' if len(finds) > 3 else ''})" if finds else ""
        words.append(f"{len(finds)} in {version} alone{some}")
    rates = [f"{column} {' to '.join(share(row, column) for row, _, _ in hunted)}"
             for column in ("missed", "late", "false hit")]
    return (f"{name} from {old} to {new}: of {len(before)} finds {', '.join(words)}; "
            f"of queries {', '.join(rates)}")


def share(row, column):
    return f"{100 * row[column] / max(row['queries'], 1):.2g} %"


def bisect(name, good, bad, arguments):
    source, package, _ = ENGINES[name]
    if source != "npm":
        fail(f"{name}: only packages of npm have versions to look through")
    versions = [v for v in json.loads(run(["npm", "view", package, "versions", "--json"]))
                if "-" not in v]
    for version in (good, bad):
        if version not in versions:
            fail(f"{version} is no version of {package}; there are: {' '.join(versions)}")
    low, high = versions.index(good), versions.index(bad)
    finds = arguments.finds or finds_folder(arguments.folder / f"{name}@{bad}", arguments)
    # Those that all kept finds need, so that any find is asked.
    options = f":{arguments.options or TAKES[name]}" if arguments.options or name in TAKES else ""
    def shown_by(version):
        return outcomes(name, install(name, version, arguments)[1] + options, finds, arguments)
    wrong, right = (shown_by(version) for version in (bad, good))
    telling = {find for find, got in wrong.items() if got in WRONG and right.get(find) == "correct"}
    if not telling:
        some = [f"{pathlib.Path(find).name} {right.get(find, 'not asked')} and {got}"
                for find, got in wrong.items()]
        fail(f"the finds in {finds} do not tell {name} {good} from {bad}: {', '.join(some[:5])}")
    print(f"{len(telling)} of {len(wrong)} finds tell {name} {good} from {bad}")
    while abs(high - low) > 1:
        middle = (low + high) // 2
        shown = shown_by(versions[middle])
        seen = {shown.get(find, "not asked") for find in telling}
        failing = bool(seen & WRONG)
        others = seen - WRONG - {"correct"}
        if others and not failing:
            fail(f"{name} {versions[middle]} answers neither right nor wrong: "
                 f"{', '.join(sorted(others))}")
        print(f"{name} {versions[middle]}: {'fails' if failing else 'correct'}")
        low, high = (low, middle) if failing else (middle, high)
    ends = [("good", low), ("bad", high)]
    for which, (kind, at) in zip(("last", "first"), ends if low < high else ends[::-1]):
        print(f"{which} {kind} version: {name} {versions[at]}")
    return 0
