#!/usr/bin/env python3
"""links.py: each relative link, anchor, path and property that a page names is there; exits with 1 otherwise.

Pages as in prose.py, and derivations. A path is a code span that begins with a folder of the project; * is as in a
shell. One with a word in capitals is a pattern, and not looked up. A property is a code span that begins with the
group of one. A planted fault may have the same group. The page of plug-ins shows each field of their claims.
"""
import fnmatch
import re
import sys

from prose import ROOT, pages

FOLDERS = ('src', 'generators', 'properties', 'fuzz', 'tests', 'corpus', 'bench', 'cmake', 'script', 'docs', 'examples',
           'web', '.github', '.clusterfuzzlite')

STORED = (ROOT / 'tests/golden/properties.txt').read_text()
FAULTS = (ROOT / 'bench/scoreboard/faults.txt').read_text()
KNOWN = re.findall(r'^{"property":"([^"]+)"', STORED, re.M) + re.findall(r'^fault: (\S+)', FAULTS, re.M)
GROUPS = {name.partition('.')[0] for name in KNOWN}
PLUGIN = ROOT / 'src/method/plugin'
CLAIMS = re.findall(r'{(?:&Features::\w+, )?"(\w+)", (?:CCDFUZZ_|\(d\.claims &)',
                    (PLUGIN / 'feature_claims.hpp').read_text() + (PLUGIN / 'worker.cpp').read_text())
ENDINGS = '.c .md .json .jsonl .hpp .cpp .txt .mjs .zst'


def without_code(text):
    return re.sub(r'^```.*?^```', '', text, flags=re.M | re.S)


def anchors(path):
    """The anchors of a page's headings, as GitHub makes them."""
    titles = re.findall(r'^#+ (.*)$', without_code(path.read_text()), re.M)
    titles = [re.sub(r'\[([^]]*)\]\([^)]*\)', r'\1', title) for title in titles]
    return {re.sub(r'[^\w\- ]', '', title.lower()).replace(' ', '-') for title in titles}


def check(page):
    text = without_code(page.read_text())
    for target in re.findall(r'\]\(([^)\s]+)\)', text):
        if re.match(r'https?:|mailto:', target):
            continue
        path, _, anchor = target.partition('#')
        file = (page.parent / path).resolve() if path else page
        if not file.exists():
            yield f'no {path}'
        elif anchor and anchor not in anchors(file):
            yield f'no heading #{anchor} in {path or page.name}'
    for path in re.findall(rf'`((?:{"|".join(map(re.escape, FOLDERS))})/[\w./*-]*)`', text):
        if not any(ROOT.glob(path)) and not re.search(r'\b[A-Z]{2,}\.|/[A-Z]{2,}$', path.replace('README.', '')):
            yield f'no {path}'
    for name in re.findall(r'`([a-z-]+\.[A-Za-z0-9_*]+)`', text):
        group, _, ending = name.partition('.')
        if group in GROUPS and f'.{ending}' not in ENDINGS.split() and not fnmatch.filter(KNOWN, name):
            yield f'no property {name}'


def main():
    found = [f'{page.relative_to(ROOT)}: {what}' for page in [*pages(), *ROOT.glob('src/**/DERIVATION.md')]
             for what in check(page)]
    page = (ROOT / 'docs/plug-ins.md').read_text()
    found += [f'docs/plug-ins.md: no "{claim}"' for claim in CLAIMS if f'"{claim}":' not in page]
    print(*found, f'{len(found)} broken', sep='\n')
    return 1 if found else 0


if __name__ == '__main__':
    sys.exit(main())
