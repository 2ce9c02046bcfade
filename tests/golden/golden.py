#!/usr/bin/env python3
"""Holds ccdfuzz to its stored outputs.

    golden.py [--update] BINARY [GROUP...]   checks all groups, or those named; exits with 1 after a difference.
                                             --update stores what BINARY prints now
    golden.py digest [PATH...]               a line for each file: its digest and name
    golden.py fields NAME... < JSON lines    those fields of each line, as text
    golden.py untimed < TEXT                 the text with times replaced

A group is the file GROUP.txt beside this one. It has rows: a shell command after "$ ", the lines of its stdout,
those of its stderr after "! ", and its exit code in brackets where that is not 0. To add a row, write its command
and update; review what changed as a diff. Rows run in a folder of their own, golden/GROUP beside BINARY, where
`inputs`, `handmade`, `corpus`, `plugins` as they are built, `ccdfuzz`, its `misbehaving` properties and the other forms
above are at hand.

Two groups ask the binary what there is. `data_sets` has a row for each family, kind and class of `generate`,
which one thread and two must make alike. `commands` stores nothing: each command must have a group, with --json
if it has that.
"""
import argparse
import base64
import concurrent.futures
import ctypes
import difflib
import fcntl
import gzip
import hashlib
import itertools
import json
import os
import re
import shlex
import shutil
import signal
import subprocess
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
SHOWN = 40  # lines of a row's difference

# What differs between runs, machines or versions, named here alone. All else is pinned, to the byte.
UNPINNED_NAMES = '|'.join([
    r'\w*seconds', r'\w*_ms',                 # times, in JSON and CSV
    'ccdfuzz',                                # the version
    'tree_bytes', 'offset', 'length', 'xxh3'  # where a compressed tree is: zstd's version
])
UNPINNED_FIELD = rf'"(?:{UNPINNED_NAMES})": ?(?:"[^"]*"|[-+.\w]+)'
HISTOGRAM = r',"times":\[[][\d,-]*\]'  # in a report's page
SYNTAX = '(?<=syntax error) while parsing .*?(?=; JSON is accepted|$)'  # in the words of the JSON library
UNPINNED_TEXT = re.compile(rf',{UNPINNED_FIELD}|{UNPINNED_FIELD},?|{HISTOGRAM}|(?<=ccdfuzz) \d+\.\d+\.\d+|{SYNTAX}',
                           re.M)
PROGRESS = re.compile(r'ccdfuzz: +\d+ %  ')  # of a run that takes long
UNPINNED_FILES = {'tables.md'}  # times in every line
UNPINNED_COMMANDS = {'bench'}                   # ratios of times


def pinned(text):
    """The text without what differs from run to run."""
    return UNPINNED_TEXT.sub('', text)


def pinned_csv(text):
    """The rows of a CSV with a header, without the columns of times."""
    rows = [line.split(',') for line in text.splitlines()]
    kept = [i for i, name in enumerate(rows[0]) if not re.fullmatch(UNPINNED_NAMES, name)] if rows else []
    return '\n'.join(','.join(row[i] for i in kept if i < len(row)) for row in rows)


# --- Filters ----------------------------------------------------------------------------------------------------


class Buffer(ctypes.Structure):
    """ZSTD_inBuffer and ZSTD_outBuffer."""
    _fields_ = [('data', ctypes.c_void_p), ('size', ctypes.c_size_t), ('at', ctypes.c_size_t)]


def decompressed(data):
    """All frames of a zstd file: compressed bytes depend on zstd's version."""
    zstd = ctypes.CDLL('libzstd.so.1')
    zstd.ZSTD_createDStream.restype = ctypes.c_void_p
    zstd.ZSTD_decompressStream.restype = ctypes.c_size_t
    stream = ctypes.c_void_p(zstd.ZSTD_createDStream())
    room = ctypes.create_string_buffer(1 << 17)
    source = ctypes.create_string_buffer(data, len(data))
    given = Buffer(ctypes.cast(source, ctypes.c_void_p), len(data), 0)
    result = bytearray()
    while True:
        taken = Buffer(ctypes.cast(room, ctypes.c_void_p), len(room), 0)
        status = zstd.ZSTD_decompressStream(stream, ctypes.byref(taken), ctypes.byref(given))
        if zstd.ZSTD_isError(ctypes.c_size_t(status)):
            raise ValueError('not a zstd file')
        result += room.raw[:taken.at]
        if given.at == given.size and taken.at < taken.size:
            zstd.ZSTD_freeDStream(stream)
            return bytes(result)


def page_data(text):
    """The data of a report's page, unpacked: neither its program nor what zlib's version decides."""
    report, *details = re.findall(r'<script id="(?:report|details-\d+)"[^>]*>(.*?)</script>', text, re.S)
    return '\n'.join([report, *(gzip.decompress(base64.b64decode(part)).decode() for part in details)])


def digest_of(data, name):
    """The first 128 bits of the sha256 of a file's pinned bytes."""
    if name.endswith('.zst'):
        data = decompressed(data)
        name = name[:-len('.zst')]
    text = data.decode()
    if name.endswith('.html'):
        text = page_data(text)
    return hashlib.sha256((pinned_csv(text) if name.endswith('.csv') else pinned(text)).encode()).hexdigest()[:32]


def digest(names):
    """A line for each file: its digest and name."""
    if not names:
        print(digest_of(sys.stdin.buffer.read(), ''))
    for name in names:
        path = Path(name)
        if not path.exists():
            sys.exit(f'digest: {name}: there is none')
        files = sorted(p for p in path.rglob('*') if p.is_file()) if path.is_dir() else [path]
        for file in files:
            unpinned = file.name in UNPINNED_FILES
            print('-' * 32 if unpinned else digest_of(file.read_bytes(), file.name), file)


def fields(names):
    """Those fields of each JSON line on stdin."""
    for line in sys.stdin:
        row = json.loads(line)
        print(*(row.get(name, '-') for name in names))


def untimed(_):
    """The lines of stdin, each time replaced and runs of spaces as one: columns are as wide as their times."""
    for line in sys.stdin:
        print(re.sub(' +', ' ', re.sub(r'\b\d+(\.\d+)? (s|ms|µs|ns)\b', 'TIME', line.rstrip())))


# --- Rows -------------------------------------------------------------------------------------------------------


DATA_SET = 'ccdfuzz generate --family {} --kind {} --contact {} --count 2 --seed 1 | digest'


def read_rows(group):
    """The rows of a group, in order: (command, lines)."""
    path = HERE / f'{group}.txt'
    text = path.read_text().splitlines() if path.exists() else []
    if group == 'data_sets':
        return [(DATA_SET.format(*line.split()[:3]), [line.split()[3]]) for line in text]
    rows = []
    for line in text:
        if line.startswith('$ '):
            if line[2:] in dict(rows):
                sys.exit(f'golden.py: {path}: twice: {line}')
            rows.append((line[2:], []))
        elif rows:
            rows[-1][1].append(line)
    return [(command, without_empty_end(lines)) for command, lines in rows]


def write_rows(group, rows):
    path = HERE / f'{group}.txt'
    if group == 'data_sets':
        names = [command.split()[3:8:2] for command, _ in rows]
        path.write_text(''.join(f'{" ".join(n)} {lines[0]}\n' for n, (_, lines) in zip(names, rows)))
    else:
        path.write_text('\n'.join(''.join(f'{line}\n' for line in ['$ ' + c, *lines]) for c, lines in rows))


def without_empty_end(lines):
    while lines and not lines[-1]:
        lines = lines[:-1]
    return lines


class Sandbox:
    """An empty folder in which rows run."""

    def __init__(self, binary, group):
        self.folder = binary.parent / 'golden' / group
        self.folder.parent.mkdir(exist_ok=True)
        self.lock = open(f'{self.folder}.lock', 'w')  # another run of the group waits
        fcntl.flock(self.lock, fcntl.LOCK_EX)
        shutil.rmtree(self.folder, ignore_errors=True)
        tools = self.folder / '.bin'
        tools.mkdir(parents=True)
        (tools / 'ccdfuzz').symlink_to(binary)
        for name in FILTERS:
            tool = tools / name
            tool.write_text(f'#!/bin/sh\nexec python3 {shlex.quote(str(HERE / "golden.py"))} {name} "$@"\n')
            tool.chmod(0o755)
        for name in ('inputs', 'handmade'):
            shutil.copytree(HERE / name, self.folder / name)  # so that no row changes them
        (self.folder / 'plugins').symlink_to(binary.parent / 'examples')
        (tools / 'misbehaving').symlink_to(binary.parent / 'tests/cli/misbehaving_properties')
        (self.folder / 'corpus').symlink_to(HERE.parent.parent / 'corpus')
        self.environment = {name: value for name, value in os.environ.items() if not name.startswith('CCDFUZZ_')}
        self.environment['LC_ALL'] = 'C.UTF-8'  # in which files are listed
        self.environment['PATH'] = f'{tools}:{self.environment["PATH"]}'

    def run(self, command):
        """What a row prints, as it is stored."""
        run = subprocess.run(['bash', '-o', 'pipefail', '-c', command], cwd=self.folder, env=self.environment,
                             stdin=subprocess.DEVNULL, capture_output=True, text=True)
        told = [line for line in pinned(run.stderr).splitlines() if not PROGRESS.match(line)]
        lines = pinned(run.stdout).splitlines() + ['! ' + line for line in told]
        return without_empty_end(lines) + ([f'[{run.returncode}]'] if run.returncode else [])

    def reproduction(self, command):
        return f'(cd {shlex.quote(str(self.folder))}; PATH=$PWD/.bin:$PATH; {command})'


def values_of(sandbox, option):
    """The values of an option of `generate`, as the error about a wrong one lists them."""
    arguments = {'--contact': 'FF', '--kind': 'RP', option: '?'}
    command = ' '.join(['ccdfuzz generate --count 1', *(word for pair in arguments.items() for word in pair)])
    found = re.search(r' is not one of (.*)', '\n'.join(sandbox.run(command)))
    if not found:
        sys.exit(f'golden.py: lists no values: {command}')
    return found[1].split(', ')


def run_data_set(sandbox, row):
    """The digest of a row's data set, made alike by one thread and by two, or the exit code if there is none."""
    found = set()
    for threads in (1, 2):
        run = subprocess.run([*row.removesuffix(' | digest').split(), '--threads', str(threads)],
                             cwd=sandbox.folder, env=sandbox.environment, capture_output=True)
        if run.returncode:
            return f'[{run.returncode}]'
        found.add(digest_of(run.stdout, ''))
    return found.pop() if len(found) == 1 else 'differs-between-1-and-2-threads'


def run_data_sets(sandbox):
    """A row for each family, kind and class."""
    rows = [DATA_SET.format(*names)
            for names in itertools.product(*(values_of(sandbox, f'--{option}')
                                             for option in ('family', 'kind', 'contact')))]
    with concurrent.futures.ThreadPoolExecutor(max_workers=2) as pool:
        return [(row, [value]) for row, value in zip(rows, pool.map(lambda row: run_data_set(sandbox, row), rows))]


def missing_commands(sandbox):
    """The commands that have no row, and those with --json that have none with it."""
    helped = '\n'.join(sandbox.run('ccdfuzz --help'))
    missing = []
    for name in re.findall(r'^  ([a-z]+) ', helped.split('Commands:')[1].split('Options:')[0], re.M):
        if name not in UNPINNED_COMMANDS:
            json_there = any(line.startswith('  --json') for line in sandbox.run(f'ccdfuzz {name} --help'))
            rows = [command for command, _ in read_rows(name) if f'ccdfuzz {name} ' in command]
            if not any('--json' in row or not json_there for row in rows):
                missing.append(f'{name}.txt has no row `ccdfuzz {name} {"--json" if json_there else ""}`')
    return missing


# --- Differences ------------------------------------------------------------------------------------------------


def parsed(line):
    try:
        value = json.loads(line)
    except ValueError:
        return None
    return value if isinstance(value, dict) else None


def flat(value, name=''):
    """The fields of a JSON value by their paths."""
    if isinstance(value, dict):
        return {k: v for key, item in value.items() for k, v in flat(item, f'{name}.{key}'.lstrip('.')).items()}
    return {name: json.dumps(value)}


def describe(old, new):
    """One changed line: which fields, where both are JSON."""
    one, other = parsed(old), parsed(new)
    if one is None or other is None:
        return [f'  - {old}', f'  + {new}']
    one, other = flat(one), flat(other)
    same = ' '.join(f'{k}={v}' for k, v in one.items() if v == other.get(k) and v.startswith('"'))
    lines = [f'  of {same[:160]}:']
    for key in [*one, *(k for k in other if k not in one)]:
        if one.get(key) != other.get(key):
            lines.append(f'    {key}: {one.get(key, "(absent)")} -> {other.get(key, "(absent)")}')
    return lines if len(lines) > 1 else [f'  - {old}', f'  + {new}']


def difference(old, new):
    lines = []
    for tag, a, b, c, d in difflib.SequenceMatcher(None, old, new, autojunk=False).get_opcodes():
        if tag == 'replace' and b - a == d - c:
            for one, other in zip(old[a:b], new[c:d]):
                lines += describe(one, other)
        elif tag != 'equal':
            lines += [f'  - {line}' for line in old[a:b]] + [f'  + {line}' for line in new[c:d]]
    return lines


def report(stored, found, sandbox):
    """Prints how the rows differ; returns how many do."""
    old, new = dict(stored), dict(found)
    count = 0
    for command in [*new, *(row for row in old if row not in new)]:
        if old.get(command) == new.get(command):
            continue
        count += 1
        print(f'{"new" if command not in old else "gone" if command not in new else "changed"}: {command}')
        lines = difference(old.get(command, []), new.get(command, []))
        print('\n'.join(lines[:SHOWN] + ([f'  ... and {len(lines) - SHOWN} lines'] if lines[SHOWN:] else [])))
        if command in new:
            print(f'  reproduce: {sandbox.reproduction(command)}')
    return count


def check(binary, group, update):
    """Runs a group; returns how many rows differ from what is stored."""
    sandbox = Sandbox(binary, group)
    if group == 'commands':
        missing = missing_commands(sandbox)
        print('\n'.join([*missing, f'commands: {len(missing)} without a row']))
        return len(missing)
    stored = read_rows(group)
    found = (run_data_sets(sandbox) if group == 'data_sets' else
             [(command, sandbox.run(command)) for command, _ in stored])
    count = report(stored, found, sandbox)
    print(f'{group}: {count} of {len(found)} rows differ')
    if update:
        write_rows(group, found)
    elif count:
        print(f'If that is meant: {HERE}/golden.py --update {binary} {group}')
    return 0 if update else count


FILTERS = {'digest': digest, 'fields': fields, 'untimed': untimed}


def main():
    if sys.argv[1:] and sys.argv[1] in FILTERS:
        return FILTERS[sys.argv[1]](sys.argv[2:])
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('--update', action='store_true', help='store the outputs of BINARY')
    parser.add_argument('binary', type=Path, metavar='BINARY')
    parser.add_argument('groups', nargs='*', metavar='GROUP')
    options = parser.parse_args()
    signal.signal(signal.SIGINT, signal.default_int_handler)  # where it is ignored, so it is in each row
    binary = options.binary.resolve(strict=True)
    groups = options.groups or [*sorted(path.stem for path in HERE.glob('*.txt') if path.stem != 'CMakeLists'), 'commands']
    return 1 if sum([check(binary, group, options.update) for group in groups]) else 0


if __name__ == '__main__':
    sys.exit(main())
