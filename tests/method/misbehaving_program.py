#!/usr/bin/env python3
"""A plug-in by the line protocol that does what its option says, something it may not do."""
import json
import os
import sys
import time

options = ""
for line in sys.stdin:
    asked = json.loads(line)
    reply = {"protocol": 1, "name": "misbehaving"}
    if asked["ask"] == "describe":
        options = asked["options"]
    else:
        reply = {"id": asked["id"], "verdict": "hit", "toi": 0.0}
        if options == "garbage":
            print("Traceback (most recent call last):", flush=True)
            continue
        if options == "nan":
            reply["toi"] = float("nan")
        if options == "inf":
            reply["toi"] = float("inf")
        if options == "stale":
            reply["id"] -= 1
        if options == "chatty":
            print(json.dumps(reply), flush=True)
        if options == "long":
            reply["message"] = "x" * 1000000
        if options == "exit":
            print("gave up", file=sys.stderr)
            sys.exit(3)
        if options == "kill":
            os.kill(os.getpid(), 9)
        if options == "hang":
            time.sleep(3600)
        if options == "close":
            os.close(1)
            time.sleep(3600)
        if options == "memory":
            hoard = "x" * (1 << 30)
            sys.exit(1)
        if options == "word":
            reply["verdict"] = "maybe"
        if options == "no toi":
            del reply["toi"]
    print(json.dumps(reply), flush=True)
