"""How the tools of script/engines ask ccdfuzz, and print what it says."""

import json
import os
import subprocess
import tempfile


def rows_and_peak(command, accepted=(0,)):
    """The rows that a command prints, and the most bytes that it or a process of it had in memory."""
    with tempfile.TemporaryFile("w+") as out, tempfile.TemporaryFile("w+") as told:
        process = subprocess.Popen(command, stdout=out, stderr=told)
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
        for file in (out, told):
            file.seek(0)
        if process.returncode not in accepted:
            raise RuntimeError((told.read().strip().splitlines() or ["it said nothing"])[-1])
        return [json.loads(line) for line in out], usage.ru_maxrss * 1024


def json_rows(command, accepted=(0,)):
    return rows_and_peak(command, accepted)[0]


def hunt_command(name, plugin, arguments, *options):
    return [arguments.program, "hunt", "--plugin", f"{name}={plugin}", "--methods",
            f"plugin:{name}", *options, "--json"]


def outcomes(name, plugin, finds, arguments):
    """What an engine shows on each of the finds."""
    rows = json_rows([arguments.program, "replay", finds, "--plugin", f"{name}={plugin}", "--methods",
                      f"plugin:{name}", "--expect", "correct", "--json"], accepted=(0, 1))
    shown = {row["case"]: row["got"] for row in rows if "got" in row}  # an object where it has a cause
    return {case: got if isinstance(got, str) else got["outcome"] for case, got in shown.items()}


def print_table(columns, rows):
    rows = [dict(zip(columns, columns)), *rows]
    widths = [max(len(str(row[c])) for row in rows) for c in columns]
    for row in rows:
        cells = [str(row[c]).ljust(w) if c in columns[:2] else str(row[c]).rjust(w)
                 for c, w in zip(columns, widths)]
        print("  ".join(cells).rstrip())
