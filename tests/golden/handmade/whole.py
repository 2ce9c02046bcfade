#!/usr/bin/env python3
"""A plug-in that says that it takes trimmed patches, and asks tdibm-c about the whole ones."""
import json
import subprocess
import sys

served = subprocess.Popen(['ccdfuzz', 'serve', 'tdibm-c'], stdin=subprocess.PIPE, stdout=subprocess.PIPE)
for line in sys.stdin:
    asked = json.loads(line)
    for patch in asked.get('patches', []):
        patch.pop('trim', None)
    served.stdin.write(json.dumps(asked).encode() + b'\n')
    served.stdin.flush()
    print(served.stdout.readline().decode(), end='', flush=True)
