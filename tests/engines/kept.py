#!/usr/bin/env python3
"""kept.py FOLDER: what script/engines says of the kept finds of an engine, where a stand-in answers for it."""
import argparse
import importlib.machinery
import importlib.util
import json
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.dont_write_bytecode = True
sys.path.insert(0, str(ROOT / "script"))


def row(find, outcome, change, **more):
    return {"case": f"corpus/engines/fcl/{find}.json", "method": "plugin:fcl", "outcome": outcome, "change": change, **more}


def main():
    folder = Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    loader = importlib.machinery.SourceFileLoader("engines", str(ROOT / "script/engines"))
    engines = importlib.util.module_from_spec(importlib.util.spec_from_loader("engines", loader))
    loader.exec_module(engines)

    def said(*rows):
        program = folder / "ccdfuzz"
        program.write_text("#!/bin/sh\ncat <<'END'\n" + "\n".join(map(json.dumps, rows)) + "\nEND\nexit 1\n")
        program.chmod(0o755)
        return engines.replay_kept("fcl", "plugin:none", argparse.Namespace(program=program))

    same = row("missed-EE", "missed", "as expected")
    of_others = {**row("reported", "late", "improvement"), "method": "plugin:fcl-0-7-0"}
    assert said(same, of_others) == ("fcl: 1 of 1 kept finds answer as kept", True)
    assert said(same, row("missed-VF", "correct", "improvement"), row("missed-VV", "late", "improvement")) == (
        "fcl: 1 of 3 kept finds answer as kept; missed-VF is mended; missed-VV is late", True)
    assert said(same, row("missed-VF", "not_asked", "improvement", note="takes no meshes")) == (
        "fcl: 1 of 2 kept finds answer as kept; missed-VF could not be asked: takes no meshes", False)
    assert said(of_others) == ("fcl: none of its kept finds could be asked", False)
    assert engines.replay_kept("ipc-toolkit", "plugin:none", None) == ("", True)  # it has no finds

    # Of two versions, which find fails in which. The stand-in answers as its plug-in is called.
    (folder / "find.json").touch()
    for version, got in (("old", "missed correct late"), ("new", "late missed correct")):
        (folder / version).write_text("".join(json.dumps({"case": f"{case}.json", "got": outcome}) + "\n"
                                              for case, outcome in zip("abc", got.split())))
    program = folder / "ccdfuzz"
    program.write_text(f"#!/bin/sh\ncase $* in *=old*) cat {folder}/old;; *) cat {folder}/new;; esac\n")
    hunted = [({"version": version, "queries": 1000, "missed": missed, "late": 3, "false hit": 0}, folder, plugin)
              for version, missed, plugin in (("1.0", 20, "old"), ("1.1", 10, "new"))]
    assert engines.what_changed("tight-inclusion", hunted, argparse.Namespace(program=program, options="")) == (
        "tight-inclusion from 1.0 to 1.1: of 3 finds 1 fail in both, 1 in 1.0 alone (c), 1 in 1.1 alone (b); "
        "of queries missed 2 % to 1 %, late 0.3 % to 0.3 %, false hit 0 % to 0 %")
    deepest = sys.modules["engine_tools.hunting"].deepest
    assert deepest([{"depth": 0.031, "depth_tolerance": 1e-4}, {"depth": 0.02, "depth_tolerance": 1e-5}]) == {
        "deepest": "0.031", "of its own": "2000 x"}
    assert deepest([{"late_by": 3e-4, "time_tolerance": 1e-4}])["of its own"] == "3 x late"


main()
