#!/usr/bin/env python3
"""bisect.py CCDFUZZ FOLDER: script/engines --bisect and --options, with stand-ins for npm and node with its adapter.

Versions called good answer one of two finds right if they are asked with the options that kept finds need, those called
bad miss it, and all others end with an error. Each misses the other find of the folder.
"""
import os
import pathlib
import shutil
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
NPM = '''#!/usr/bin/env python3
import json, os, sys
versions = dict(pair.split("=") for pair in os.environ["VERSIONS"].split())
if sys.argv[1] == "view":
    print(json.dumps(list(versions)))
elif versions.get(sys.argv[-1].rpartition("@")[2]) is None:
    sys.exit("npm error No matching version found\\nnpm error A complete log of this run is at /x")
'''
NODE = '''#!/usr/bin/env python3
import json, os, sys
versions = dict(pair.split("=") for pair in os.environ["VERSIONS"].split())
kind, options = versions[sys.argv[1].split("@")[1].split("/")[0]], ""
for line in sys.stdin:
    asked = json.loads(line)
    options = asked.get("options", options)
    if "nonsense" in options:
        reply = {"refused": "options", "message": "unknown option nonsense"}
    elif asked["ask"] == "describe":
        reply = {"protocol": 1, "takes_bodies": True, "accepts": [[{"shape": "hull", "max_degree": 8}] * 2]}
    else:
        is_hit = {"good": "mesh=1" in options, "bad": False}[kind] and len(asked["patches"][0]["positions"]) == 1
        reply = {"id": asked["id"], **({"verdict": "hit", "toi": 0} if is_hit else {"verdict": "miss"})}
    print(json.dumps(reply), flush=True)
'''


def run(folder, program, versions, *arguments):
    done = subprocess.run([ROOT / "script/engines", *arguments, "--program", program, "--folder", folder / "engines"],
                          capture_output=True, text=True,
                          env={**os.environ, "PATH": f"{folder}:{os.environ['PATH']}", "VERSIONS": versions})
    return done.returncode, done.stdout + done.stderr


def main():
    program, folder = sys.argv[1], pathlib.Path(sys.argv[2])
    folder.mkdir(parents=True, exist_ok=True)
    for name, text in ("npm", NPM), ("node", NODE):
        (folder / name).write_text(text)
        (folder / name).chmod(0o755)
    finds = folder / "finds"
    finds.mkdir(exist_ok=True)
    for name in ("missed-VV", "missed-VV-capsule"):
        shutil.copy(ROOT / f"corpus/engines/rapier/{name}.json", finds)

    def bisect(versions, good, bad):
        return run(folder, program, versions, "rapier", "--bisect", good, bad, "--finds", finds)

    failures = []
    found = "last good version: rapier {}\nfirst bad version: rapier {}\n".format
    for versions, good, bad, code, wanted in [
            ("1.0=good 2.0=good 3.0=good 4.0=bad 5.0=bad", "1.0", "5.0", 0, found("3.0", "4.0")),
            ("1.0=bad 2.0=bad 3.0=good 4.0=good 5.0=good", "5.0", "1.0", 0, 
             "last bad version: rapier 2.0\nfirst good version: rapier 3.0\n"),
            ("1.0=good 2.0=good 3.0=other 4.0=bad 5.0=bad", "1.0", "5.0", 2,
             "rapier 3.0 answers neither right nor wrong: error\n"),
            ("1.0=good 2.0=good 3.0=other 4.0=other", "1.0", "4.0", 2, "do not tell rapier 1.0 from 4.0: missed-VV"),
            ("1.0=good 2.0=good", "1.0", "2.0", 2, "missed-VV.json correct and correct\n"),
            ("1.0=good 2.0=good", "1.0", "7.0", 2, "7.0 is no version of")]:
        got, text = bisect(versions, good, bad)
        if got != code or wanted not in text:
            failures.append(f"--bisect {good} {bad} of {versions}: exit code {got}\n{text}")
    got, text = run(folder, program, "1.0=good", "rapier@9.9")
    if got != 77 or "No matching version found" not in text:
        failures.append(f"a version that is not there: exit code {got}\n{text}")
    got, text = run(folder, program, "1.0=good", "rapier@9.9", "rapier@1.0", "--options", "nonsense=1")
    if got != 2 or "rapier skipped" not in text or "unknown option nonsense" not in text:
        failures.append(f"options that there are not: exit code {got}\n{text}")
    sys.exit("\n".join(failures) or 0)


main()
