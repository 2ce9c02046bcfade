#!/usr/bin/env python3
"""A plug-in that asks the oracle about another query than its own, or says something else. The option says what
is wrong: the last thousandth of the step is left out ("last", "last-of-meshes"), a contact of a mesh at 0
("start"), bodies that spin go the shorter way round ("wraps"), or backs of faces count as fronts ("sides"). Or bodies
turn about the mean of their points ("centre"), or the other way round ("sense")."""
import json
import math
import subprocess
import sys

PAIRS = [[{'shape': 'point'}, {'shape': 'triangle', 'max_degree': 1}], [{'shape': 'curve', 'max_degree': 1}] * 2]
BODIES = [[{'shape': 'hull'}] * 2]
TURNS = {'takes_bodies': True, 'takes_turns': True, 'takes_angles': True, 'accepts': BODIES}
CLAIMS = {'last': {'ordinary': True, 'accepts': PAIRS},
          'last-of-meshes': {'ordinary': True, 'takes_meshes': True, 'accepts': BODIES},
          'start': {'takes_meshes': True, 'accepts': BODIES},
          'sides': {'ordinary': True, 'takes_one_sided': True, 'accepts': BODIES},
          'centre': TURNS,
          'sense': TURNS,
          'wraps': {'ordinary': True, 'takes_bodies': True, 'takes_spins': True, 'accepts': BODIES}}


def wrapped(velocity, step):
    """That of the shorter way round to where a spin is after the step."""
    angle = step * math.hypot(*velocity)
    return [x * math.remainder(angle, 2 * math.pi) / angle if angle > math.pi else x for x in velocity]


served = subprocess.Popen(['ccdfuzz', 'serve', 'oracle'], stdin=subprocess.PIPE, stdout=subprocess.PIPE)
option = ''
for line in sys.stdin:
    asked = json.loads(line)
    if asked['ask'] == 'describe':
        option = asked['options']
        print(json.dumps({'protocol': 1} | CLAIMS[option]), flush=True)
        continue
    if 'last' in option:
        asked['t_max'] *= 0.999
    for spin in [body['spin'] for body in asked['patches'] if 'spin' in body] if option == 'wraps' else []:
        spin['velocity'] = wrapped(spin['velocity'], asked['t_max'])
    for body in [body for body in asked['patches'] if 'turn' in body]:
        turn, points = body['turn'], body['positions']
        if option == 'centre':
            turn['centre'] = [sum(x) / len(points) for x in zip(*points)]
        elif option == 'sense':
            turn['from'], turn['to'] = ([q[0]] + [-x for x in q[1:]] for q in (turn['from'], turn['to']))
    for body in asked['patches'] if option == 'sides' else []:
        body.pop('sides', None)
    served.stdin.write(json.dumps(asked).encode() + b'\n')
    served.stdin.flush()
    answer = json.loads(served.stdout.readline())
    if option == 'start' and answer.get('toi') == 0:
        answer = {'id': asked['id'], 'verdict': 'miss'}
    print(json.dumps(answer), flush=True)
