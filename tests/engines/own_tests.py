#!/usr/bin/env python3
"""own_tests.py CCDFUZZ FOLDER: each stored find of an engine, exported as a test of that engine alone, fails there.

Finds are corpus/engines/NAME/*.json. The test of an engine of npm needs it where script/engines has put it; those of
FCL and Bullet need Debian's packages. Where none is installed, the exit code is 77.
"""
import json
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
CPP = {"fcl": "fcl", "fcl-bodies": "fcl", "bullet": "bullet"}


def runs_of(name, test, folder):
    """The commands that run a test; None where the engine is not installed."""
    if name in CPP:
        flags = subprocess.run(["pkg-config", "--cflags", "--libs", CPP[name]], capture_output=True, text=True)
        if flags.returncode != 0:
            return None
        options = [flag for flag in flags.stdout.split() if not flag.startswith("-std=")]
        program = folder / f"{test.stem}_test"
        return [["c++", "-std=c++17", test, "-o", program, *options, "-lgtest_main", "-lgtest"], [program]]
    installed = sorted((ROOT / "build/engines").glob(f"{name}@*/node_modules"))
    if not installed:
        return None
    place = installed[-1].parent / test.name
    place.write_text(test.read_text())
    return [["node", place]]


def check(ccdfuzz, find, name, folder):
    """An error, or None; False where the engine is not installed."""
    test = folder / f"{find.stem}.{'cpp' if name in CPP else 'mjs'}"
    subprocess.run([ccdfuzz, "export", find, "--as", name, "-o", test], check=True, capture_output=True)
    commands = runs_of(name, test, folder)
    if commands is None:
        return False
    for command in commands[:-1]:
        subprocess.run(command, check=True)
    done = subprocess.run(commands[-1], capture_output=True, text=True)
    told = done.stdout + done.stderr
    if done.returncode == 1 and ("AssertionError" in told or "FAILED" in told):
        return None
    return f"{find}: its test ends with {done.returncode}: {told[-500:]}"


def main():
    ccdfuzz, folder = sys.argv[1], Path(sys.argv[2])
    folder.mkdir(parents=True, exist_ok=True)
    checked, errors, absent = 0, [], set()
    for find in sorted((ROOT / "corpus/engines").glob("*/*.json")):
        name = find.parent.name
        assert f"plugin:{name}" in json.loads(find.read_text())["expect"], find
        result = check(ccdfuzz, find, name, folder)
        if result is False:
            absent.add(name)
            continue
        checked += 1
        if result:
            errors.append(result)
    print(f"{checked} finds fail in tests of their engines' own; not installed: {', '.join(sorted(absent)) or 'none'}")
    print("\n".join(errors))
    sys.exit(1 if errors else 0 if checked else 77)


main()
