#!/usr/bin/env python3
"""A plug-in that answers by what it was asked before: hit and miss by turns. With the option "fails" it is
inconclusive, and fails at its 20th query."""
import json
import sys

asks = 0
fails = False
for line in sys.stdin:
    asked = json.loads(line)
    if asked['ask'] == 'describe':
        fails = asked['options'] == 'fails'
        print('{"protocol":1,"accepts":[[{"shape":"point"},{"shape":"point"}]]}', flush=True)
        continue
    asks += 1
    if fails and asks == 20:
        raise RuntimeError('singular matrix at step 3')
    verdict = 'inconclusive' if fails else 'hit' if asks % 2 else 'miss'
    print(json.dumps({'id': asked['id'], 'verdict': verdict, 'toi': 0}), flush=True)
