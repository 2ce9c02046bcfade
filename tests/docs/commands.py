#!/usr/bin/env python3
"""commands.py [--update] BINARY: holds docs/commands.md to what `ccdfuzz COMMAND --help` prints.

Exits with 1 after a difference. --update stores what BINARY prints now. Lines are wrapped at 100 columns.
"""
import difflib
import re
import subprocess
import sys
import textwrap
from pathlib import Path

PAGE = Path(__file__).resolve().parents[2] / 'docs' / 'commands.md'
WIDTH = 100
HEAD = """# Commands

Which options does each command have? This page is what `ccdfuzz COMMAND --help` prints, made by
`python3 tests/docs/commands.py --update build/release/ccdfuzz`. Do not edit it by hand.
"""


def help_of(binary, *command):
    run = subprocess.run([binary, *command, '--help'], capture_output=True, text=True, check=True)
    # The number of cores, the default of --threads, differs between machines.
    return re.sub(r'(--threads [^\[=]*)(=\d+|\[\d+\])', lambda m: m[1] + ' ' * len(m[2]), run.stdout.rstrip())


def wrapped(line):
    """The line in lines of at most WIDTH columns, those after the first indented as its last column is."""
    gap = max((m.end() for m in re.finditer(r'\S {2,}(?=\S)', line)), default=0)
    indent = gap or len(line) - len(line.lstrip())
    return textwrap.wrap(line, WIDTH, subsequent_indent=' ' * indent, break_on_hyphens=False,
                         break_long_words=False, drop_whitespace=True) or ['']


def section(title, text):
    lines = [part for line in text.splitlines() for part in wrapped(line)]
    return '\n'.join([f'## {title}', '', '```text', *lines, '```', ''])


def page(binary):
    general = help_of(binary)
    commands = re.findall(r'^  ([a-z]+) {2,}', general, re.M)
    if not commands:
        sys.exit('commands.py: `ccdfuzz --help` lists no commands')
    end = general.splitlines()[-3:]  # the exit codes, which every command's help repeats
    sections = [section('ccdfuzz', general)]
    for name in commands:
        lines = help_of(binary, name).splitlines()
        if lines[-len(end):] == end:
            lines = lines[:-len(end)]
        sections.append(section(name, '\n'.join(lines).rstrip()))
    return '\n'.join([HEAD, *sections])


def main():
    *options, binary = sys.argv[1:]
    made = page(Path(binary).resolve(strict=True))
    if options == ['--update']:
        PAGE.write_text(made)
        return 0
    stored = PAGE.read_text() if PAGE.exists() else ''
    if made == stored:
        return 0
    print(*difflib.unified_diff(stored.splitlines(), made.splitlines(), 'docs/commands.md', '--help', lineterm=''),
          sep='\n')
    print(f'If that is meant: python3 tests/docs/commands.py --update {binary}')
    return 1


if __name__ == '__main__':
    sys.exit(main())
