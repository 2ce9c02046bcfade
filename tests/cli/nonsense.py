#!/usr/bin/env python3
"""nonsense.py CCDFUZZ CASE: gives every option of every command nonsense.

The options are those of `ccdfuzz COMMAND --help`, so that a new one is covered by itself. Each run has
5 s of processor time, 1 GB and an empty folder to work in. It must end with exit code 2 and an error that
names the option and the value. The exceptions are listed below with their reasons. No run may end by a
signal or an internal error, or leave a temporary file.
"""

import os
import re
import shutil
import subprocess
import sys
import tempfile

NONSENSE = [
    b"", b"nan", b"-1", b"1e999", b"x" * 300, b"/dev/null/nowhere", b".", b"\x01\xff\xfe\x80", b"0x",
    b" 1", b"9" * 40, b"%s%n", b"y" * 100000,
]

# However long the value is.
LONGEST_ERROR = 4000

# Options that write to a file or folder of any name but the empty one.
WRITTEN = {"--output", "--csv", "--report", "--corpus", "--save"}

# What is no nonsense for an option.
SENSE = {
    "--t-max-factors": [b"9" * 40],  # any number from 1 on
    "--choices": [b""],  # no choices: the simplest input
    # Any folder.
    "--known": [b"."],
    "corpus": [b"."],
    "csv": [b"."],
    "input": [b"."],
    "source": [b"."],
}

CASE = "case.json"
CSV_POINTS = ["0,1,0,1,1,1", "0,1,0,1,0,1", "1,1,0,1,0,1", "0,1,1,1,0,1"] * 2

# What makes a command that ends soon out of one option.
ARGUMENTS = {
    "hunt": ["--cases", "1", "--methods", "tdibm", "--max-pops", "20"],
    "query": [CASE, "--methods", "tdibm"],
    "trace": [CASE, "--methods", "tdibm"],
    "generate": ["--contact", "VV", "--kind", "RP", "--count", "1", "--output", "made.jsonl"],
    "evaluate": [CASE, "--methods", "tdibm"],
    "import": ["queries.csv", "--as", "vertex-face", "--output", "imported.jsonl"],
    "export": [CASE, "--output", "exported.csv"],
    "verify": [CASE],
    "prove": [CASE, "--output", "proven.jsonl"],
    "merge": ["finds", "--output", "merged"],
    "triage": [CASE, "--methods", "tdibm", "--output", "finds"],
    "replay": [CASE],
    "minimize": [CASE, "--method", "tdibm"],
    "report": [".", "--output", "page"],
    "bench": ["--count", "1", "--methods", "tdibm-c", "--classes", "VV"],
    "check": ["paper.eps_coeff", "--count", "1", "--save", "saved"],
    "methods": [],
    "properties": [],
}


def run(arguments):
    limited = ["/bin/sh", "-c", 'ulimit -t 5; ulimit -v 1048576; exec "$@"', "sh"]
    return subprocess.run([*limited, PROGRAM, *arguments], stdin=subprocess.DEVNULL, capture_output=True)


class Option:
    """An option or an argument of a command, as its help shows it."""

    def __init__(self, head, text, is_positional):
        words = head.split()
        self.names = [words[0].removesuffix("...")] if is_positional else [w.strip(",") for w in words if w[0] == "-"]
        self.is_positional = is_positional
        self.takes_value = is_positional or len(words) > len(self.names)
        self.excludes = self.listed(text, "Not with ")
        self.needs = self.listed(text, "Needs ")

    @staticmethod
    def listed(text, title):
        found = re.search(title + r"(--[\w-]+(?:, --[\w-]+)*)", text)
        return found[1].split(", ") if found else []


def options_of(command):
    """Those that take a value."""
    text = run([command, "--help"]).stdout.decode()
    for group, body in re.findall(r"^(\S[^\n]*):\n((?:  .*\n)+)", text, re.M):
        if group.startswith("Example"):
            continue
        for head, more in re.findall(r"^  (\S.*?)(?:  +|\n)((?:.*\n)(?:    .*\n)*)", body, re.M):
            option = Option(head, " ".join(more.split()), group == "Arguments")
            if option.takes_value:
                yield option


def arguments_for(command, option, all_options):
    """The usual arguments but for the option itself and what it excludes."""
    needed = [o for o in all_options if set(o.names) & set(option.needs)]
    left_out = set(option.names + option.excludes).union(*(o.excludes for o in needed))
    positionals = [o.names[0] for o in all_options if o.is_positional]
    if option.is_positional or left_out & set(positionals):
        left_out |= set(positionals)
    aliases = {name: o.names[-1] for o in all_options for name in o.names}
    left_out = {aliases.get(name, name) for name in left_out}
    kept, usual = [], list(ARGUMENTS[command])
    while usual:
        word = usual.pop(0)
        name = word if word.startswith("--") else positionals[0] if positionals else ""
        value = [usual.pop(0)] if word.startswith("--") else []
        if name not in left_out:
            kept += [word, *value]
    for name in option.needs:
        if name not in kept:
            kept += [name, "1"]
    return kept


def shown(value):
    return value.decode("utf-8", "backslashreplace")


def complaint(option, value, result):
    """What is wrong with how the program ended; None if nothing is."""
    error = result.stderr.decode("utf-8", "replace")
    if result.returncode < 0:
        return f"signal {-result.returncode}"
    if result.returncode not in (0, 1, 2):
        return f"exit code {result.returncode}"
    name = option.names[-1]
    if result.returncode != 2:
        return None if value and name in WRITTEN else f"exit code {result.returncode}"
    if len(error) > LONGEST_ERROR:
        return f"an error of {len(error)} characters"
    names_a_file = option.is_positional and value
    if not names_a_file and not any(name in error for name in option.names):
        return "does not name the option"
    # Of a list, the first part that is wrong.
    is_plain = re.fullmatch(rb"[ -~]+", value) is not None
    if is_plain and shown(value).strip().split(",")[0][:20] not in error:
        return "does not name the value"
    return None


def main():
    global PROGRAM
    PROGRAM = os.path.abspath(sys.argv[1])
    listed = run(["--help"]).stdout.decode().split("Commands:")[1].split("Options:")[0]
    commands = re.findall(r"^  (\w+) {2,}\w", listed, re.M)
    assert set(commands) == set(ARGUMENTS), set(commands) ^ set(ARGUMENTS)
    failures, runs = 0, 0
    case = os.path.abspath(sys.argv[2])
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        for command in commands:
            all_options = list(options_of(command))
            for option in all_options:
                rest = arguments_for(command, option, all_options)
                for value in NONSENSE:
                    is_option = option.is_positional and value.startswith(b"-")
                    if is_option or value in SENSE.get(option.names[-1], []):
                        continue
                    name = option.names[-1].encode()
                    given = [value] if option.is_positional else [name, value] if not value else [name + b"=" + value]
                    os.makedirs("run/finds")
                    os.chdir("run")
                    shutil.copy(case, CASE)
                    with open("queries.csv", "w", encoding="ascii") as queries:
                        queries.write("\n".join(CSV_POINTS) + "\n")
                    result = run([command, *given, *rest])
                    runs += 1
                    wrong = complaint(option, value, result)
                    left = [os.path.join(f, n) for f, _, names in os.walk(".") for n in names
                            if n.startswith(".ccdfuzz-tmp")]
                    os.chdir("..")
                    shutil.rmtree("run")
                    if left:
                        wrong = f"leaves {left}"
                    if wrong:
                        failures += 1
                        print(f"{command} {shown(b' '.join(given))[:60]!r} {' '.join(rest)}: {wrong}: "
                              f"{result.stderr.decode('utf-8', 'replace')[:300]!r}")
    print(f"{runs} runs, {failures} failures")
    return failures > 0


if __name__ == "__main__":
    sys.exit(main())
