#!/usr/bin/env python3
"""source_tests.py CCDFUZZ FOLDER: a test that is exported for an engine of a source tree builds and passes there.

It fails where the contact is said to come before it does, and those of stored finds fail. FOLDER is that of script/engines. The trees are in the folder that CCDFUZZ_ENGINE_SOURCES
names; where none is, the exit code is 77.
"""
import os
import re
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
GENERATED = {"hulls": ["--family", "bodies", "--contact", "VF"],
             "turning": ["--family", "turning", "--contact", "VF"],
             "vertex-face": ["--construction", "one-sided", "--contact", "VF", "--shape", "point,triangle:1"],
             "edge-edge": ["--construction", "one-sided", "--contact", "EE", "--shape", "curve:1,curve:1"]}
FLAT = ROOT / "corpus/engines/rapier2d/late-EE.json"
ENGINES = {"box2d": [FLAT], "box3d": ["hulls", "turning"], "tight-inclusion": ["vertex-face", "edge-edge"],
           "ipc-toolkit": ["vertex-face", "edge-edge"]}


def is_passing(name, source, test, folder):
    """Builds the test with the engine's sources, and runs it."""
    subprocess.run(["cmake", "-S", ROOT / "examples/engines", "-B", folder, f"-DENGINE={name}",
                    f"-DENGINE_SOURCE={source}", f"-DFIND={test}", "-DCMAKE_BUILD_TYPE=Release"], check=True,
                   stdout=subprocess.DEVNULL)
    subprocess.run(["cmake", "--build", folder], check=True, stdout=subprocess.DEVNULL)
    return subprocess.run([folder / "find"]).returncode == 0


def main():
    ccdfuzz, folder = sys.argv[1], Path(sys.argv[2])
    trees = Path(os.environ.get("CCDFUZZ_ENGINE_SOURCES") or "/nonexistent")
    there = [name for name in ENGINES if (trees / name).exists()]
    print(f"CCDFUZZ_ENGINE_SOURCES has no {', '.join(name for name in ENGINES if name not in there) or 'other'}")
    for name in there:
        own = folder / name
        own.mkdir(parents=True, exist_ok=True)
        for find in sorted((ROOT / "corpus/engines" / name).glob("*.json")):
            test = own / f"{find.stem}.{'c' if name.startswith('box') else 'cpp'}"
            subprocess.run([ccdfuzz, "export", find, "--as", name, "-o", test], check=True)
            assert not is_passing(name, trees / name, test, own / "build"), test
        for case in ENGINES[name]:
            if case in GENERATED:
                options, case = GENERATED[case], own / f"{case}.jsonl"
                subprocess.run([ccdfuzz, "generate", *options, "--kind", "RP", "--count", "1", "-o", case], check=True)
            subprocess.run([ccdfuzz, "export", case, "--as", name, "-o", f"{own}/"], check=True)
            test = max(own.glob(f"{case.stem}*.c*"))
            assert is_passing(name, trees / name, test, own / "build"), test
        test.write_text(re.sub(r"(<= |share, )-?[0-9][0-9.e-]*", r"\g<1>-1", test.read_text()))
        assert not is_passing(name, trees / name, test, own / "build"), test
    sys.exit(0 if there else 77)


main()
