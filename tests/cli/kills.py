#!/usr/bin/env python3
"""kills.py CCDFUZZ MISBEHAVING_PROPERTIES DIE_AT [KILLS [SEED [COMMAND...]]]: ends every command that writes by SIGKILL.

Each command of COMMANDS first runs to its end: that is what it makes. Then it begins again from the same
folder, is killed at a random moment, and that up to three times, before it runs to its end once more. Half of
the moments are times; the others are calls that change files (the library DIE_AT, of die_at.cpp). KILLS (by
default 30) are shared among the commands, or those that are named.

After every kill
  - each file under a final name is whole: as it was, as it becomes in the end, or, in a folder of finds, an
    entry that `verify` accepts or the input of a claim; a page ends with its last line;
  - no file is gone that stays in the end.
After the last run, which nobody kills,
  - each file is what it is without a kill, but for times. In a folder of finds of a hunt each find of that is
    there; one that was stored before a kill may not have been shrunk or asked about;
  - no temporary file is left.
Until then hidden temporary files and what ends in ".partial", which goes on, may hold anything.
"""

import json
import os
import random
import shutil
import signal
import subprocess
import sys
import tempfile
import time
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "golden"))
import golden  # noqa: E402

CCDFUZZ, MISBEHAVING, DIE_AT = (str(Path(p).resolve()) for p in sys.argv[1:4])
KILLS = int(sys.argv[4]) if len(sys.argv) > 4 else 30
SEED = int(sys.argv[5]) if len(sys.argv) > 5 else time.time_ns() % 10**9
CORPUS = Path(__file__).resolve().parent.parent.parent / "corpus"
INPUTS = Path(golden.HERE) / "inputs"
TEMPORARY = ".ccdfuzz-tmp-"

# How a command is said: words, "ccdfuzz" left out. `before`: commands that make what it begins with; the data
# set that it writes may be there already, of another seed. `finds`: folders of finds in what it writes.
# `claims`: of finds of claims. `unsure`: folders of finds that depend on where it was killed (see above). `last`:
# once this file is as in the end, all others but the page's are. `bare`: a data set that loses its truths first.
HUNT = "hunt --methods tdibm,tdibm-e-literal --max-pops 300 --threads 2 --corpus finds"
EVALUATE = "evaluate set.jsonl --methods tdibm,tdibm-c --threads 2"
SET = "generate --contact EF --kind RP --shape triangle:2"
BARE = "generate --contact VV --kind RP --count 40 --seed 3 -o bare.jsonl"
SHARES = [f"{SET} --count 200 --shard {i}/2 -o share{i}" for i in (0, 1)]
COMMANDS = {
    "generate": dict(run=f"{SET} --count 200 --seed 1 -o set.jsonl.zst", last="set.jsonl.zst",
                     before=[f"{SET} --count 20 --seed 2 -o set.jsonl.zst"]),
    "generate --paper": dict(run="generate --paper --one-in 3000 -o paper.jsonl", last="paper.jsonl"),
    "generate --shard": dict(run=SHARES[1]),
    "prove": dict(run="prove bare.jsonl -o proved.jsonl", before=[BARE], bare="bare.jsonl",
                  last="proved.jsonl"),
    "import": dict(run="import edge-edge --round -o set.jsonl", copies={"edge-edge": INPUTS / "edge-edge"}),
    "export": dict(run=f"export {CORPUS}/cases/{{some}} --as gtest -o tests.cpp"),
    "minimize": dict(run="minimize case.json --method tdibm -o small.json",
                     copies={"case.json": CORPUS / "cases/02d71658a4bbf5e134290167cd922434.json"}),
    "evaluate": dict(run=f"{EVALUATE} -o answers --report page", last="answers/answers.jsonl",
                     before=[f"{SET} --count 60 -o set.jsonl"]),
    "report": dict(run=f"report {CORPUS} -o page"),
    "hunt": dict(run=f"{HUNT} --cases 4 --report page", before=[f"{HUNT} --cases 2 --seed 2"],
                 finds=["finds"], unsure=["finds"]),
    "check": dict(run="check made_up.fails_on_empty made_up.fails_on_all made_up.segfaults --save finds",
                  program=MISBEHAVING, claims=["finds"]),
    "triage": dict(run="triage inputs --methods tdibm,tdibm-c --max-pops 1000 --seconds 1000 --remove -o finds",
                   copies={"inputs": "some"}, finds=["finds"]),
    "merge of a data set": dict(run="merge share0 share1 -o set.jsonl.zst", last="set.jsonl.zst",
                                before=SHARES + [f"{SET} --count 20 --seed 2 -o set.jsonl.zst"]),
    "merge of answers": dict(run="merge a0 a1 -o answers", last="answers/answers.jsonl",
                             before=[f"{SET} --count 60 -o set.jsonl"] +
                             [f"{EVALUATE} --shard {i}/2 -o a{i}" for i in (0, 1)]),
    "merge of corpora": dict(run=f"merge {CORPUS} here -o finds", finds=["finds"], claims=["finds/claims"],
                             before=[f"{HUNT} --cases 2", f"{HUNT[:-5]}here --cases 2 --seed 2"]),
    "replay --update": dict(run="replay finds --update --methods tdibm,tdibm-c --expect correct",
                            copies={"finds": CORPUS / "cases"}, finds=["finds"]),
}


def words_of(text):
    words = text.split()
    if "{some}" in text:
        at = next(i for i, word in enumerate(words) if "{some}" in word)
        folder = Path(words[at]).parent
        words[at:at + 1] = sorted(str(p) for p in folder.glob("*.json"))
    return words


def run(program, text, folder, more=None):
    """A command to its end. more: of the environment."""
    done = subprocess.run([program, *words_of(text)], cwd=folder, stdin=subprocess.DEVNULL, capture_output=True,
                          env={**os.environ, **(more or {})})
    if done.returncode not in (0, 1):
        sys.exit(f"kills.py: {text}: exit code {done.returncode}: {done.stderr.decode()}")


def is_killed(program, text, folder, moment=None, call=None):
    """True iff the command was still at work at this moment, in seconds, or came to this call that changes a
    file, and was killed then."""
    more = {} if call is None else {"LD_PRELOAD": DIE_AT, "CCDFUZZ_TEST_DIE_AT": str(call)}
    process = subprocess.Popen([program, *words_of(text)], cwd=folder, stdin=subprocess.DEVNULL,
                               stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, env={**os.environ, **more})
    try:
        process.wait(timeout=moment)
    except subprocess.TimeoutExpired:
        process.send_signal(signal.SIGKILL)
    return process.wait() == -signal.SIGKILL


def files_of(folder):
    """The files under final names: path → bytes."""
    return {
        str(path.relative_to(folder)): path.read_bytes()
        for path in sorted(Path(folder).rglob("*"))
        if path.is_file() and not path.name.startswith(TEMPORARY) and not path.name.endswith(".partial")
    }


def meaning(name, data):
    """What is the same in every run."""
    if name.endswith(".html"):
        return data.endswith(b"</html>\n")
    if name.endswith(".md"):
        return data.endswith(b"\n")
    return golden.digest_of(data, name)


def lies_in(name, folders):
    return any(name.startswith(folder + "/") for folder in folders)


class Command:
    def __init__(self, name, work, random_):
        self.name, self.random = name, random_
        self.what = COMMANDS[name]
        self.program = self.what.get("program", CCDFUZZ)
        self.finds = self.what.get("finds", [])
        self.first, self.folder = work / "first", work / "now"
        self.first.mkdir(parents=True)
        for to, source in self.what.get("copies", {}).items():
            if source == "some":
                (self.first / to).mkdir()
                for path in sorted((CORPUS / "cases").glob("0*.json")):
                    shutil.copy(path, self.first / to)
            elif source.is_dir():
                shutil.copytree(source, self.first / to)
            else:
                shutil.copy(source, self.first / to)
        for text in self.what.get("before", []):
            run(CCDFUZZ, text, self.first)
        if bare := self.what.get("bare"):
            path = self.first / bare
            cases = [json.loads(line) for line in path.read_text().splitlines()]
            path.write_text("".join(json.dumps({**case, "truth": {}}) + "\n" for case in cases))
        self.begin()
        self.before = files_of(self.folder)
        start, calls = time.monotonic(), work / "calls"
        run(self.program, self.what["run"], self.folder, {"LD_PRELOAD": DIE_AT, "CCDFUZZ_TEST_CALLS": str(calls)})
        self.seconds, self.calls = time.monotonic() - start, int(calls.read_text())
        self.after = files_of(self.folder)
        if self.before == self.after:
            sys.exit(f"kills.py: {name}: writes nothing")

    def begin(self):
        shutil.rmtree(self.folder, ignore_errors=True)
        shutil.copytree(self.first, self.folder)

    def fail(self, why):
        sys.exit(f"kills.py: {self.name}: {why}; in {self.folder}, seed {SEED}")

    def is_killed(self):
        """True iff it was, at a random moment."""
        if self.random.random() < 0.5:
            moment = {"moment": self.random.uniform(0, 1.1) * self.seconds}
        else:
            moment = {"call": self.random.randrange(self.calls)}
        return is_killed(self.program, self.what["run"], self.folder, **moment)

    def is_as_in_the_end(self, name, now):
        return name in self.after and name in now and meaning(name, now[name]) == meaning(name, self.after[name])

    def check_whole(self):
        """After a kill."""
        now, cases = files_of(self.folder), []
        last = self.what.get("last")
        if last in now and now[last] != self.before.get(last):
            for name in self.after:
                if not name.startswith("page/") and not self.is_as_in_the_end(name, now):
                    self.fail(f"{last} is there before {name}")
        for name in set(self.before) & set(self.after) - set(now):
            self.fail(f"{name} is gone")
        for name, data in now.items():
            if data == self.before.get(name):
                continue
            if self.is_as_in_the_end(name, now):
                continue
            if lies_in(name, self.what.get("claims", [])):
                json.loads(data)
            elif lies_in(name, self.finds):
                cases.append(name)
            else:
                self.fail(f"{name} is neither what it was nor what it becomes")
        cases = [name for name in cases if name.endswith(".json")]
        if cases and subprocess.run([CCDFUZZ, "verify", *cases], cwd=self.folder,
                                    capture_output=True).returncode != 0:
            self.fail(f"verify refuses one of {cases}")

    def check_end(self):
        """After the last run."""
        now = files_of(self.folder)
        for name in self.after:
            if name not in now:
                self.fail(f"{name} is not there in the end")
            if lies_in(name, self.what.get("unsure", [])):
                continue
            if not self.is_as_in_the_end(name, now):
                self.fail(f"{name} is not what it is without a kill")
        for name in set(now) - set(self.after):
            # The larger find of a failure, beside the smaller.
            if not lies_in(name, self.finds):
                self.fail(f"{name} is too much")
        if left := [str(p) for p in self.folder.rglob(TEMPORARY + "*")]:
            self.fail(f"{left} are left")
        if self.finds:
            self.check_whole()

    def round(self, most):
        """Kills up to three times, then runs to the end. Returns how often."""
        self.begin()
        kills = 0
        for _ in range(min(most, self.random.randint(1, 3))):
            if not self.is_killed():
                break
            kills += 1
            self.check_whole()
        run(self.program, self.what["run"], self.folder)
        self.check_end()
        return kills


def main():
    random_ = random.Random(SEED)
    work = Path(tempfile.mkdtemp(prefix="kills-"))
    rounds = kills = 0
    commands = [Command(name, work / name.replace(" ", "_"), random_) for name in sys.argv[6:] or COMMANDS]
    counts = {command.name: 0 for command in commands}
    while kills < KILLS:
        command = min(commands, key=lambda c: counts[c.name])
        share = -(-KILLS // len(commands))
        done = command.round(max(1, min(share - counts[command.name], KILLS - kills)))
        counts[command.name] += done
        kills += done
        rounds += 1
        if rounds > 20 * KILLS:
            sys.exit(f"kills.py: {command.name} is over before it can be killed")
    shutil.rmtree(work)
    print(f"{kills} kills, seed {SEED}: " + ", ".join(f"{n} {name}" for name, n in counts.items()))


if __name__ == "__main__":
    main()
