#!/usr/bin/env python3
"""adapters.py CCDFUZZ FOLDER: adapters are short, and say the version that script/engines and the corpus say.

No adapter has more than 80 lines, as docs/engines/README.md says. Each kept find has a version in its origin. Where FCL
or Bullet is installed, its adapter says the version that Debian's package has.
"""
import json
import re
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.dont_write_bytecode = True
sys.path.insert(0, str(ROOT / "script"))
from engine_tools.install import ADAPTERS, ENGINES, install_debian

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
        yield name, json.loads(rows.stdout)["description"].partition(";")[0].rpartition(" ")[2], version


def main():
    ccdfuzz, folder = sys.argv[1], Path(sys.argv[2])
    lines = {path: len(path.read_text().splitlines()) for path in ADAPTERS.glob("*/adapter.*")}
    errors = [f"{path}: {count} lines" for path, count in lines.items() if count > 80]
    kept = {path: json.loads(path.read_text()) for path in (ROOT / "corpus/engines").glob("*/*.json")}
    assert len(lines) >= 14 and len(kept) >= 40
    for path, find in kept.items():
        version = find["origin"].get("version", "none")
        if not VERSION.fullmatch(version):
            errors.append(f"{path}: origin.version: {version}")
    for name, said, version in said_by_adapters(ccdfuzz, folder):
        if said != version or not VERSION.fullmatch(said):
            errors.append(f"{name}: its adapter says {said}, its package {version}")
    for path in ADAPTERS.glob("*/adapter.mjs"):
        if re.search(r"version: ['\"`]", path.read_text()):
            errors.append(f"{path}: version: is not what the package has")
    sys.exit("\n".join(errors) or 0)


main()
