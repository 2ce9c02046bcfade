#!/usr/bin/env python3
"""shell.py PAGE CCDFUZZ: runs the commands that a page shows, one after the other in a folder of their own.

Each command of an `sh` block must end with exit code 0, or with the one in EXPECTED. Those in NOT_RUN are not run, for
the reason given; a script that they name must be there. A block of another language after "Save this as `NAME`" is
saved so. In the text each `ccdfuzz COMMAND --option` must be a command with that option, and each `ctest -R` must
find tests.
"""
import re
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]

# By page: the beginning of a command, and its exit code or why it is not run. Each row must be of use.
EXPECTED = {
    'README.md': {'build/release/ccdfuzz replay build/mine': 1},
    'docs/plug-ins.md': {'build/release/ccdfuzz replay named-finds --plugin mine=plugin:./libmine.so --methods': 1},
}
NOT_RUN = {
    'README.md': {
        'script/hunt': 'installs packages, builds, and takes a minute',
        'script/test': 'builds all that there is',
    },
    'CONTRIBUTING.md': {
        'script/setup': 'installs packages; build.setup_on_other_machines tests it',
        'cmake': 'configures this very build', 'ninja': 'builds this very build', 'ctest': 'runs this very test',
        'script/test': 'builds all that there is',
        'python3 tests/docs/commands.py': 'writes into the sources; docs.commands_are_what_help_prints checks the page',
        'tests/golden/golden.py': 'writes into the sources; the golden tests check them',
    },
    'SECURITY.md': {
        '#!': 'a script', 'exec bwrap': 'its second line; tests/cli/plugin_test.cpp runs it',
        'ccdfuzz': 'needs that script; tests/cli/plugin_test.cpp runs it',
    },
    'docs/fuzzing.md': {'script/fuzz': 'needs clang, and builds for minutes'},
    'docs/results.md': {'for s in': 'takes two hours'},
    'docs/scoreboard.md': {
        'cmake': 'configures a second build', 'ninja': 'builds it for half an hour', 'build/scoreboard': 'takes hours',
    },
}


def blocks(text):
    """(language, lines, text before) of each block."""
    end = 0
    for match in re.finditer(r'^```(\w*)\n(.*?)^```$', text, re.M | re.S):
        yield match[1], match[2], text[end:match.start()]
        end = match.end()


def commands(block):
    """The commands of a block: lines, with those that a backslash or a loop continues."""
    found, loop = [], False
    for line in re.sub(r' *\\\n *', ' ', block).splitlines():
        if loop:
            found[-1] += '\n' + line
        elif line.strip():
            found.append(line)
        loop = (loop or line.startswith('for ')) and line != 'done'
    return found


def row_of(rows, command):
    return next((row for row in rows if command.startswith(row)), None)


def run_blocks(name, text, folder):
    expected, not_run, used, count = EXPECTED.get(name, {}), NOT_RUN.get(name, {}), set(), 0
    for language, block, before in blocks(text):
        saved = re.search(r'Save this as `([\w.]+)`', before)
        if saved and language != 'sh':
            (folder / saved[1]).write_text(block)
        for command in commands(block) if language == 'sh' else []:
            script = re.match(r'script/\S+', command)
            if script and not (ROOT / script[0]).exists():
                yield f'no {script[0]}'
            row = row_of(not_run, command)
            if row is not None:
                used.add(row)
                continue
            row = row_of(expected, command)
            used.add(row)
            print(f'$ {command}', flush=True)
            run = subprocess.run(['bash', '-c', command], cwd=folder, stdin=subprocess.DEVNULL,
                                 stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
            count += 1
            if run.returncode != expected.get(row, 0):
                print(run.stdout)
                yield f'exit code {run.returncode}: {command}'
    yield from (f'a row of no command: {row}' for row in [*expected, *not_run] if row not in used)
    print(f'{count} commands ran')


def check_spans(text, ccdfuzz):
    """Commands that the text names."""
    text = re.sub(r'^```.*?^```$', '', text, flags=re.M | re.S)
    helps = {}
    for span in re.findall(r'`((?:build/release/)?ccdfuzz [a-z][^`]*)`', text):
        command = re.search(r'ccdfuzz ([a-z]+)', span)[1]
        if command not in helps:
            run = subprocess.run([ccdfuzz, command, '--help'], capture_output=True, text=True)
            helps[command] = run.stdout if run.returncode == 0 or command == 'serve' else None
        if helps[command] is None:
            yield f'no command: {span}'
            continue
        for option in re.findall(r'(?<= )--[a-z-]+', span):
            if not re.search(rf'{option}\b', helps[command]):
                yield f'no option {option}: {span}'


def check_patterns(text, build):
    """What ctest is told to run: each alternative of a pattern is of some test."""
    listed = subprocess.run(['ctest', '-N'], cwd=build, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, text=True)
    tests = re.findall(r'Test +#\d+: (\S+)', listed.stdout)
    for pattern in re.findall(r"ctest\b[^`#]*?-R\s+('[^']*'|[\w.]+)", text):
        for part in pattern.strip("'").split('|'):
            if not any(re.search(part, test) for test in tests):
                yield f'no test of ctest -R {part}'


def main():
    name, ccdfuzz = sys.argv[1], Path(sys.argv[2]).resolve(strict=True)
    text = (ROOT / name).read_text()
    with tempfile.TemporaryDirectory() as scratch:
        folder = Path(scratch)
        (folder / 'build/release').mkdir(parents=True)
        (folder / 'build/release/ccdfuzz').symlink_to(ccdfuzz)
        for part in ('src', 'examples', 'corpus', 'properties', 'tests', 'web'):
            (folder / part).symlink_to(ROOT / part)
        failed = [*run_blocks(name, text, folder), *check_spans(text, ccdfuzz),
                  *check_patterns(text, ccdfuzz.parent)]
    print(*(f'{name}: {what}' for what in failed), sep='\n')
    return 1 if failed else 0


if __name__ == '__main__':
    sys.exit(main())
