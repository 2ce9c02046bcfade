#!/usr/bin/env python3
"""adapters.py CCDFUZZ FOLDER: adapters are short, and say the version that script/engines and the corpus say.

Each folder of an adapter has a line in ENGINES, a promise.json and a page. No adapter has more than 80 lines, as
docs/engines/README.md says. Each kept find has a version in its origin, and each
miss and late answer a depth. Where FCL or Bullet is installed, its adapter says the version that Debian's package has,
and `replay --update` writes the depth of its finds. Nothing is drawn that Bullet's refuses, with options that draw more.
"""
import json
import re
import shutil
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.dont_write_bytecode = True
sys.path.insert(0, str(ROOT / "script"))
from engine_tools.install import ADAPTERS, ENGINES, TAKES, install_debian

VERSION = re.compile(r"[0-9]+(\.[0-9]+)+")


def said_by_adapters(ccdfuzz, folder):
    """Of each of Debian's engines that is installed: what its adapter says, and its package."""
    for name, (source, package, module) in ENGINES.items():
        if source != "debian":
            continue
        try:
            _, plugin, version = install_debian(folder, name, package, module)
        except RuntimeError:
            continue
        rows = subprocess.run([ccdfuzz, "methods", plugin, "--json"], capture_output=True, text=True, check=True)
        yield name, plugin, json.loads(rows.stdout)["description"].partition(";")[0].rpartition(" ")[2], version


def depths_written(ccdfuzz, name, plugin, folder):
    """Errors of the kept finds of an engine, where `replay --update` is to write what origin says of the depth."""
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    kept = {path.name: json.loads(path.read_text()) for path in (ROOT / "corpus/engines" / name).glob("*.json")}
    for file, find in kept.items():
        origin = {key: value for key, value in find["origin"].items() if key != "depth"}
        (folder / file).write_text(json.dumps({**find, "origin": origin}))
    options = f":{TAKES[name]}" if name in TAKES else ""
    subprocess.run([ccdfuzz, "replay", folder, "--update", "--plugin", f"{name}={plugin}{options}"], check=True,
                   stdout=subprocess.DEVNULL)
    for file, find in kept.items():
        now = json.loads((folder / file).read_text())
        was, depth = (value["origin"].pop("depth", 0) for value in (find, now))
        for name_of_tolerance in {"depth_tolerance", "time_tolerance"} - find["origin"].keys():
            now["origin"].pop(name_of_tolerance, None)
        if abs(was - depth) > 1e-9 * was or now != find:
            yield f"{name}/{file}: a depth of {was} became {depth}"


def refused(ccdfuzz, name, plugin, folder):
    """How many of some drawn queries an adapter refuses."""
    told = subprocess.run([ccdfuzz, "hunt", "--cases", "12", "--plugin", f"{name}={plugin}", "--methods", f"plugin:{name}",
                           "--shrink", "none", "--corpus", folder, "--json"], capture_output=True, text=True, check=True)
    return sum(json.loads(row).get("not_asked", 0) for row in told.stdout.splitlines())


def main():
    ccdfuzz, folder = sys.argv[1], Path(sys.argv[2])
    lines = {path: len(path.read_text().splitlines()) for path in ADAPTERS.glob("*/adapter.*")}
    errors = [f"{path}: {count} lines" for path, count in lines.items() if count > 80]
    folders = {path.name for path in ADAPTERS.iterdir() if path.is_dir()}
    errors += [f"{ADAPTERS / name}: is either no folder, or has no line in ENGINES" for name in folders ^ ENGINES.keys()]
    for name in folders:
        page = ROOT / f"docs/engines/{name.removesuffix('-bodies')}.md"
        errors += [f"{path}: is not there" for path in (ADAPTERS / name / "promise.json", page) if not path.exists()]
    kept = {path: json.loads(path.read_text()) for path in (ROOT / "corpus/engines").glob("*/*.json")}
    assert len(lines) >= 14 and len(kept) >= 40
    for path, find in kept.items():
        version = find["origin"].get("version", "none")
        if not VERSION.fullmatch(version):
            errors.append(f"{path}: origin.version: {version}")
        if any(shown in ("missed", "late") for shown in find["expect"].values()) and not find["origin"].get("depth", 0) > 0:
            errors.append(f"{path}: has no origin.depth")
    for name, plugin, said, version in said_by_adapters(ccdfuzz, folder):
        errors += depths_written(ccdfuzz, name, plugin, folder / f"{name}-kept")
        if name == "bullet" and (count := refused(ccdfuzz, name, f"{plugin}:{TAKES[name]}", folder / "drawn")):
            errors.append(f"bullet: its adapter refuses {count} of what is drawn for it")
        if said != version or not VERSION.fullmatch(said):
            errors.append(f"{name}: its adapter says {said}, its package {version}")
    for path in ADAPTERS.glob("*/adapter.mjs"):
        if re.search(r"version: ['\"`]", path.read_text()):
            errors.append(f"{path}: version: is not what the package has")
    sys.exit("\n".join(errors) or 0)


main()
