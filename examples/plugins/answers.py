#!/usr/bin/env python3
"""A plug-in by lines of JSON: the answers that a batch code gave of a whole file of queries.

Its option is FILE+ANSWERS: the cases (JSONL) that the code was given, and its answers, a line a case
in their order: `miss`, `hit TOI`, or `inconclusive`. What is not in the file is refused.
"""

import hashlib
import json
import sys


def number(x):
    return float.fromhex(x) if isinstance(x, str) and "x" in x.lower() else float(x)


def numbers(values):
    return [numbers(x) if isinstance(x, list) else number(x) for x in values]


def key(query):
    """The query without what only says where it comes from, in few bytes."""
    patches = [{field: numbers(x) if isinstance(x, list) else x for field, x in patch.items()}
               for patch in query["patches"]]
    text = json.dumps([patches, number(query["t_max"]), number(query.get("separation", 0))])
    return hashlib.blake2b(text.encode(), digest_size=16).digest()


def read(cases, answers):
    found, digest = {}, hashlib.sha256()
    with open(cases) as queries, open(answers) as lines:
        for query, line in zip(queries, lines, strict=True):
            digest.update(line.encode())
            found[key(json.loads(query))] = line.split()
    return found, digest.hexdigest()


def answer(words):
    if words is None:
        return {"verdict": "refused"}
    if words[0] != "hit":
        return {"verdict": words[0]}
    return {"verdict": "hit", "toi": float(words[1])}


for line in sys.stdin:
    asked = json.loads(line)
    if asked["ask"] == "describe":
        try:
            given, version = read(*asked["options"].split("+"))
        except (OSError, TypeError, ValueError) as error:
            reply = {"refused": "options", "message": f"FILE+ANSWERS: {error}"}
        else:
            # Other answers are another version, so that no run goes on with them.
            reply = {"protocol": 1, "name": "answers of a batch", "version": version,
                     "takes_ends": True, "takes_separation": True}
    else:
        reply = {"id": asked["id"], **answer(given.get(key(asked)))}
    print(json.dumps(reply), flush=True)
