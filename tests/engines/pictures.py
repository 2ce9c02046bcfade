#!/usr/bin/env python3
"""pictures.py FOLDER: each picture of docs/engines is small, in a page, and what slice.py writes of its find (to a
fifth of a pixel: mathematical libraries differ). It shows an overlap: an area, where no body is flat."""
import re
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
NUMBER = r"(?<![#\w])\d+\.?\d*"
pages = "".join(page.read_text() for page in (ROOT / "docs/engines").glob("*.md"))
made = Path(sys.argv[1]) / "made.svg"
for picture in sorted((ROOT / "docs/engines/pictures").glob("*.svg")):
    kept = picture.read_text()
    words = re.search("<desc>(.*)</desc>", kept)[1].split()
    subprocess.run([sys.executable, *words, "-o", made], check=True, cwd=ROOT)
    texts, numbers = zip(*((re.sub(NUMBER, "", t), map(float, re.findall(NUMBER, t))) for t in (kept, made.read_text())))
    assert texts[0] == texts[1] and all(abs(x - y) <= 0.2 for x, y in zip(*numbers)), picture
    assert len(kept) < 20000 and f"(pictures/{picture.name})" in pages, picture
    red = [[tuple(map(float, p.split(","))) for p in points.split()]
           for points in re.findall('class="overlap" points="(.*)"', kept)]
    area = max((abs(sum(p[0] * q[1] - p[1] * q[0] for p, q in zip(r, r[1:] + r[:1]))) / 2 for r in red), default=0)
    assert 'class="overlap"' in kept and (area > 4 or re.search(r": a (point|segment|triangle|mesh)\b", kept)), picture
