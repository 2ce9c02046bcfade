#!/usr/bin/env python3
"""citation.py: exits with 1 unless CITATION.cff has the keys that version 1.2.0 of its format requires, names no
key twice, and cites the version and the authors that CMakeLists.txt and LICENSE have."""
import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
REQUIRED = {'cff-version', 'message', 'title', 'authors'}
KNOWN = REQUIRED | {'abstract', 'type', 'version', 'license', 'keywords', 'references'}


def main():
    text = (ROOT / 'CITATION.cff').read_text()
    keys = re.findall(r'^([\w-]+):', text, re.M)
    found = [f'{key}: is missing' for key in REQUIRED - set(keys)]
    found += [f'{key}: no key of the format' for key in set(keys) - KNOWN]
    found += [f'{key}: twice' for key in set(keys) if keys.count(key) > 1]
    version = re.search(r'project\(\s*ccdfuzz\s+VERSION\s+([\d.]+)', (ROOT / 'CMakeLists.txt').read_text())[1]
    if f'\nversion: {version}\n' not in text:
        found.append(f'version: is not {version}, as in CMakeLists.txt')
    authors = re.search(r'Copyright \(c\) \d+ (.*)', (ROOT / 'LICENSE').read_text())[1]
    if f'\nauthors:\n  - name: {authors}\n' not in text:
        found.append(f'authors: are not "{authors}", as in LICENSE')
    for reference in text.split('\nreferences:\n')[1:]:
        found += [f'references: {key}: is missing' for key in ('type', 'title', 'authors') if f' {key}:' not in reference]
    print(*found, f'{len(found)} violations of CITATION.cff', sep='\n')
    return 1 if found else 0


if __name__ == '__main__':
    sys.exit(main())
