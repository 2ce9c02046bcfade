"""Every numbered law has a line of code that cites it, and a test of its name. No comment cites another.

A law is declared in a DERIVATION.md ("- **L3. Roots.** ...") or in a header ("/// Law R1: ...").
A line cites it by a comment that is none of a declaration ("// Law L3"), in a source of the same folder.
Its tests are TEST(LawL3, ...) or RC_GTEST_PROP(LawL3, ...), anywhere in tests, or the check of a property,
above which stands "/// Law L3".
"""
import collections
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).parents[2]
LAW = r"[A-Z]\d*"
NAMED = rf"\bLaws? ((?:{LAW}(?:, | and )?)+)"


def declared(folder):
    derivation = folder / "DERIVATION.md"
    laws = re.findall(rf"^- \*\*({LAW})\.", derivation.read_text(), re.M)
    for header in folder.glob("*.hpp"):
        laws += re.findall(rf"^ *(?:///|//) Law ({LAW}):", header.read_text(), re.M)
    return set(laws)


def cited(folder):
    lines = collections.defaultdict(list)
    for source in sorted(folder.glob("*.?pp")):
        for number, line in enumerate(source.read_text().splitlines(), 1):
            comment = re.search(r"(?<!/)//(?!/)(.*)", line)
            if not comment:
                continue
            for some in re.findall(NAMED, comment[1]):
                for law in re.findall(LAW, some):
                    lines[law].append(f"{source.relative_to(ROOT)}:{number}")
    return lines


tests = set()
for source in (ROOT / "tests").rglob("*_test.cpp"):
    tests |= set(re.findall(rf"^(?:TEST|RC_GTEST_PROP)\(Law({LAW}),", source.read_text(), re.M))
for source in (ROOT / "properties").glob("*.cpp"):
    for some in re.findall(rf"^/// {NAMED}", source.read_text(), re.M):
        tests |= set(re.findall(LAW, some))

failures = count = 0
for folder in sorted(path.parent for path in (ROOT / "src").rglob("DERIVATION.md")):
    lines = cited(folder)
    for source in sorted(folder.glob("*.?pp")):
        for some in re.findall(NAMED, source.read_text()):
            for law in set(re.findall(LAW, some)) - declared(folder):
                failures += 1
                print(f"{source.relative_to(ROOT)}: cites Law {law}, which there is not", file=sys.stderr)
    for law in sorted(declared(folder), key=lambda name: (name[0], int(name[1:] or 0))):
        count += 1
        print(f"{folder.relative_to(ROOT)}: {law}: {', '.join(lines[law])}")
        for lacks, what in ((not lines[law], "no line cites it"), (law not in tests, "no test has its name")):
            failures += lacks
            if lacks:
                print(f"{folder.relative_to(ROOT)}: Law {law}: {what}", file=sys.stderr)
sys.exit(1 if failures or count < 15 else 0)
