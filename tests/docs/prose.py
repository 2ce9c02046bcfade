#!/usr/bin/env python3
"""prose.py [-v]: measures the English of the pages and of the comments; exits with 1 past a limit.

Pages are README.md, CONTRIBUTING.md, SECURITY.md, CHANGELOG.md, corpus/README.md, those of docs, and the
plug-ins'. Per page: words per sentence (MEAN_WORDS on average, MAX_WORDS at most, a few more in OTHERS; cells of
tables too), lines of at most MAX_COLUMNS outside of tables and JSON, and no sentence that opens with a bare "Of".
A code span is one word. Comments of the sources have as many words a sentence at most, where what has no two
letters in a row is no word, but part of a formula. None opens with a bare "Of". -v prints all numbers.
"""
import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
MEAN_WORDS = 18
MAX_WORDS = 25
MAX_WORDS_OF_OTHERS = 30
OTHERS = ('CHANGELOG.md', 'docs/formats.md', 'docs/guarantees.md', 'docs/plug-ins.md')
MAX_COLUMNS = 100
ROOMS = ('src', 'generators', 'properties', 'fuzz', 'bench', 'examples')
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
    most = MAX_WORDS_OF_OTHERS if str(name).startswith(OTHERS) else MAX_WORDS
    for number, block, in_table in blocks(lines):
        for sentence in END.split(plain(block)):
            count = len(words(sentence))
            if in_table:
                longest_cell = max(longest_cell, count)
            elif count:
                lengths.append(count)
            if count > most:
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


def sources():
    return (path for room in ROOMS for path in sorted((ROOT / room).rglob('*')) if path.suffix in ('.hpp', '.cpp', '.h'))


def of_comments():
    """The comments with a sentence that opens with a bare "Of"."""
    found = []
    for path in sources():
        for number, block in comment_blocks(path.read_text().splitlines()):
            if re.search(r'(^|[.:;!?] )Of\b', block):
                found.append(f'{path.relative_to(ROOT)}:{number}: {block[:70]}')
    return found


def comment_blocks(lines):
    """(line number, text) for each paragraph and item of comments; tables and what is indented are left out."""
    number, text, kind, indent = 0, [], '', 0
    for i, line in enumerate([*lines, ''], 1):
        match = re.match(r'(.*?)(?<![:"\w])(///?<?)(?: (.*))?$', line)
        comment = (match[3] or '').rstrip() if match else ''
        item = BLOCK.match(comment)
        if item or not comment:
            indent = len(item[0]) if item else 0
        continues = text and indent and re.match(rf' {{{indent}}}\S', comment)
        is_table = not continues and (comment.startswith('    ') or re.match(r'  .*\S {2,}\S', comment))
        starts = not comment or match[1].strip() or match[2] != kind or is_table or item
        kind = match[2] if match else ''
        if starts and text:
            yield number, ' '.join(text)
            text = []
        if comment and not is_table:
            number = number if text else i
            text.append(comment[item.end() if item else 0:].strip())


def long_comments():
    """The sentences of comments with more than MAX_WORDS words."""
    found = []
    for path in sources():
        for number, block in comment_blocks(path.read_text().splitlines()):
            for sentence in END.split(plain(block)):
                count = sum(1 for word in sentence.split() if re.search(r'[^\W\d_]{2}', word))
                if count > MAX_WORDS:
                    found.append(f'{path.relative_to(ROOT)}:{number}: {count} words: {sentence}')
    return found


def main():
    verbose = sys.argv[1:] == ['-v']
    found = [violation for path in pages() for violation in check_page(path, verbose)]
    found += [f'{comment}: opens with a bare "of"' for comment in of_comments()]
    found += long_comments()
    print(*found, f'{len(found)} violations', sep='\n')
    return 1 if found else 0


if __name__ == '__main__':
    sys.exit(main())
