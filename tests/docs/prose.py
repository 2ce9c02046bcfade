#!/usr/bin/env python3
"""prose.py [-v]: measures the English of the pages and of the doc comments; exits with 1 past a limit.

Pages are README.md, CONTRIBUTING.md, SECURITY.md, CHANGELOG.md, corpus/README.md, those of docs, and the
plug-ins'. Per page: words per sentence (MEAN_WORDS on average, MAX_WORDS at most, cells of tables too), lines
of at most MAX_COLUMNS outside of tables and JSON, and no sentence that opens with a bare "Of". A code span is
one word. Doc comments of the sources may open with a bare "of" OF_COMMENTS times. -v prints all numbers.
"""
import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
MEAN_WORDS = 18
MAX_WORDS = 30
MAX_COLUMNS = 100
OF_COMMENTS = 0
# A full stop, unless it is that of an abbreviation.
END = re.compile(r'(?<!\bEq)(?<!\bEqs)(?<!\bFig)(?<!\bFigs)(?<!\be\.g)(?<!\bi\.e)(?<!\bal)[.!?]["\')*]*\s+')
BLOCK = re.compile(r'\s*(?:[-*+]|\d+\.)\s+|#+\s')


def pages():
    return [ROOT / name for name in ('README.md', 'CONTRIBUTING.md', 'SECURITY.md', 'CHANGELOG.md', 'corpus/README.md',
                                     'examples/plugins/README.md')] + sorted((ROOT / 'docs').glob('**/*.md'))


def plain(text):
    """Text without markup: a code span is one word, a link is its text."""
    text = re.sub(r'`+[^`]+`+', 'CODE', text)
    return re.sub(r'!?\[([^]]*)\]\([^)]*\)', r'\1', text)


def words(sentence):
    return [word for word in sentence.split() if re.search(r'\w', word)]


def blocks(lines):
    """(line number, text, in a table) for each paragraph, item and cell; headings and code are left out."""
    fence, number, text = False, 0, []
    for i, line in enumerate([*lines, ''], 1):
        if line.lstrip().startswith('```'):
            fence = not fence
            line = ''
        elif fence:
            continue
        starts = not line.strip() or line.startswith('|') or BLOCK.match(line)
        if starts and text:
            yield number, ' '.join(text), False
            text = []
        if line.startswith('|'):
            for cell in re.split(r'(?<!\\)\|', plain(line).strip('|')):
                yield i, cell, True
        elif line.strip() and not line.startswith('#'):
            if not text:
                number = i
            text.append(BLOCK.sub('', line, 1) if starts else line.strip())


def check_page(path, verbose):
    """The violations of a page."""
    name, lines = path.relative_to(ROOT), path.read_text().splitlines()
    found, lengths, longest_cell = [], [], 0
    for number, block, in_table in blocks(lines):
        for sentence in END.split(plain(block)):
            count = len(words(sentence))
            if in_table:
                longest_cell = max(longest_cell, count)
            elif count:
                lengths.append(count)
            if count > MAX_WORDS:
                found.append(f'{name}:{number}: {count} words: {sentence[:70]}')
            if re.match(r'Of\b', sentence.strip()):
                found.append(f'{name}:{number}: opens with a bare "Of": {sentence[:70]}')
    language = None
    for number, line in enumerate(lines, 1):
        if line.lstrip().startswith('```'):
            language = line.strip()[3:] if language is None else None
        elif len(line) > MAX_COLUMNS and language != 'json' and not line.startswith(('|', '![')):
            found.append(f'{name}:{number}: {len(line)} columns')
    mean = sum(lengths) / max(1, len(lengths))
    if mean > MEAN_WORDS:
        found.append(f'{name}: {mean:.1f} words per sentence on average')
    if verbose:
        print(f'{name}: {len(lengths)} sentences of {mean:.1f} words, longest {max(lengths, default=0)}, '
              f'longest cell {longest_cell}')
    return found


def of_comments():
    """The doc comments that open with a bare "of", and sentences in them that open with "Of"."""
    found = []
    for room in ('src', 'generators', 'properties', 'fuzz'):
        for path in sorted((ROOT / room).rglob('*.?pp')):
            before = ''
            for number, line in enumerate(path.read_text().splitlines(), 1):
                match = re.search(r'///<? *(.*)', line)
                comment = match[1] if match else ''
                opens = not before and re.match(r'[oO]f\b', comment) and not line.lstrip().startswith('///<')
                follows = re.search(r'(^|[.:;!?] )Of\b', comment)
                if opens or follows:
                    found.append(f'{path.relative_to(ROOT)}:{number}: {comment}')
                before = comment if match and line.lstrip().startswith('///') else ''
    return found


def main():
    verbose = sys.argv[1:] == ['-v']
    found = [violation for path in pages() for violation in check_page(path, verbose)]
    comments = of_comments()
    if verbose or len(comments) > OF_COMMENTS:
        print(f'{len(comments)} doc comments open with a bare "of"; {OF_COMMENTS} may')
        print(*comments, sep='\n')
    print(*found, f'{len(found)} violations', sep='\n')
    return 1 if found or len(comments) > OF_COMMENTS else 0


if __name__ == '__main__':
    sys.exit(main())
