#!/usr/bin/env python3
"""adapters.py: no adapter of an engine has more than 80 lines, as docs/engines/README.md says."""
import sys
from pathlib import Path

ADAPTERS = Path(__file__).resolve().parents[2] / "examples/engines"
lines = {path: len(path.read_text().splitlines()) for path in ADAPTERS.glob("*/adapter.*")}
assert len(lines) >= 14
sys.exit("\n".join(f"{path}: {count} lines" for path, count in lines.items() if count > 80) or 0)
