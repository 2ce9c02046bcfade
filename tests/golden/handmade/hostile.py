"""Writes small files that ask for much, for hostile.txt."""
import json


def digits(count):
    return ''.join(str(1 + (i * i + 3 * i) % 9) for i in range(count))


def fraction(count):
    return f'1{digits(count - 1)}/9{digits(count - 1)}'


def tensor8(height, up, scale=1.0):
    """A patch of the highest degrees, whose coordinates are a few bits."""
    return {'shape': 'tensor', 'degree': [8, 8],
            'positions': [[x * scale for x in (i // 9 / 8, i % 9 / 8, height + i * i % 7 / 16)] for i in range(81)],
            'velocities': [[0, 0, up] for _ in range(81)]}


def write(name, patches, t_max, count=1, **truth):
    case = {'format': 'ccdfuzz-case', 'version': 2, 'patches': patches, 't_max': t_max, 'truth': truth}
    with open(name, 'w') as file:
        file.write((json.dumps(case, separators=(',', ':')) + '\n') * count)


def witness(digit_count):
    x = fraction(digit_count)
    return {'witness': {'t': x, 'uv': [[x, x], [x, x]]}}


NEAR = [tensor8(0, 1), tensor8(1, -1)]
STILL = {'shape': 'triangle', 'degree': 1, 'positions': [[0, 0, 0], [1, 0, 0], [0, 1, 0]], 'velocities': [[0, 0, 0]] * 3}
FALLING = [{'shape': 'point', 'positions': [[0.1, 0.2, 1]], 'velocities': [[0, 0, -1]]}, STILL]
CREEPING = [{'shape': 'point', 'positions': [[0.1, 0.2, 2.0**-1000]],
             'velocities': [[2.0**-900, -2.0**-990, -2.0**-1000]]}, STILL]
# In small numbers and nearer than planes tell apart, one of them moved by a large number.
FAR_APART = [tensor8(0, 0, 2.0**-600), tensor8(0.25, 0, 2.0**-600)]
FAR_APART[0]['velocities'][0][0] = 0.5
WORD = {'collides': False, 'proof': 'rational-tdibm'}

write('polynomial.json', FALLING, 2,
      certificate={'root': {'polynomial': ['3'] * 120_000, 'from': '0', 'by': fraction(200)}})
write('until.json', FALLING, 2, certificate={'clear': {'kind': 'L', 'until': fraction(20_000), 'closed': True}})
write('witness.json', NEAR, 1, **witness(100_000))
write('real.json', FALLING, f'0x{"0" * 400_000}4.{"0" * 400_000}p0')
write('longest-witness.json', NEAR, 1, **witness(5000))
write('longest-until.json', CREEPING, 2, clear_until='1/2',
      certificate={'clear': {'kind': 'L', 'until': fraction(5000), 'closed': True}})
write('witnesses.jsonl', NEAR, 1, 200, **witness(5000))
write('words.jsonl', NEAR, 1, 200, **WORD)
write('far-apart.json', FAR_APART, 1)
write('far-apart-word.json', FAR_APART, 1, **WORD)
write('near.json', NEAR, 1)
with open('edges.csv', 'w') as file:
    for i in range(8):
        over = f'1{digits(900)}'
        file.write(f'{digits(900 + i)},{over},{digits(899 - i)},{over},{digits(890 + 2 * i)},{over}\n')
