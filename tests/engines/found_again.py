#!/usr/bin/env python3
"""found_again.py CCDFUZZ FOLDER: ten seconds of FCL find again a kind of failure that is known, and show its finds.

What stands in corpus/engines/fcl must be answered as it says there. Where FCL is not installed, the exit code is 77.
"""
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]


def main():
    ccdfuzz, folder = sys.argv[1], Path(sys.argv[2])
    hunted = subprocess.run([ROOT / "script/engines", "fcl", "--seconds", "10", "--program", ccdfuzz, "--folder",
                             folder], capture_output=True, text=True)
    if hunted.returncode != 0:
        print(hunted.stdout + hunted.stderr)
        sys.exit(hunted.returncode)
    kept = {path.stem for path in (ROOT / "corpus/engines/fcl").glob("*.json")}
    found = {path.stem.removeprefix("plugin_fcl-") for path in (folder / "fcl/finds").glob("*.json")}
    print(f"{hunted.stdout}found again: {', '.join(sorted(kept & found))}")
    assert any(kind.startswith("missed") for kind in kept & found)
    assert f"fcl: {len(kept)} of {len(kept)} kept finds answer as kept\n" in hunted.stdout


main()
