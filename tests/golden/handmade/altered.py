#!/usr/bin/env python3
"""A plug-in that asks the oracle about another query than its own. The option says which: one that ends a
thousandth of the step sooner ("last")."""
import json
import subprocess
import sys

PAIRS = [[{'shape': 'point'}, {'shape': 'triangle', 'max_degree': 1}], [{'shape': 'curve', 'max_degree': 1}] * 2]
CLAIMS = {'last': {'ordinary': True, 'accepts': PAIRS}}
served = subprocess.Popen(['ccdfuzz', 'serve', 'oracle'], stdin=subprocess.PIPE, stdout=subprocess.PIPE)
option = ''
for line in sys.stdin:
    asked = json.loads(line)
    if asked['ask'] == 'describe':
        option = asked['options']
        print(json.dumps({'protocol': 1} | CLAIMS[option]), flush=True)
        continue
    if option == 'last':
        asked['t_max'] *= 0.999
    served.stdin.write(json.dumps(asked).encode() + b'\n')
    served.stdin.flush()
    print(served.stdout.readline().decode(), end='', flush=True)
