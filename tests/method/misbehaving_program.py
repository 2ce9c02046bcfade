#!/usr/bin/env python3
"""A plug-in by the line protocol that does what its option says, something it may not do."""
import ctypes
import json
import os
import signal
import subprocess
import sys
import time


def parent_of(pid):
    with open(f"/proc/{pid}/stat") as stat:
        return int(stat.read().rsplit(")", 1)[1].split()[1])


def murder(whom):
    """Kills who watches over it, after it has started two that hold its output open."""
    for new_session in (False, True):
        left = subprocess.Popen(["sleep", "3600"], start_new_session=new_session)
        print(left.pid, file=sys.stderr, flush=True)
    parent = os.getppid()
    grandparent = parent_of(parent)
    if whom == "both":
        ctypes.CDLL(None).prctl(1, 0)  # PR_SET_PDEATHSIG: it outlives its parent
        os.kill(grandparent, signal.SIGSTOP)
    if whom in ("parent", "both"):
        os.kill(parent, signal.SIGKILL)
    if whom in ("grandparent", "both"):
        os.kill(grandparent, signal.SIGKILL)
    if whom == "group":
        os.kill(0, signal.SIGKILL)
    if whom == "both":
        os._exit(0)
    time.sleep(3600)


options = ""
asks = 0
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
        asks += 1
        if options == "by turns" and asks % 2 == 0:
            reply["verdict"] = "miss"
        if options == "another uv":
            reply["uv"] = [[0, 0], [0, 0.5 * (asks % 2)]]
        if options == "stale":
            reply["id"] -= 1
        if options == "chatty":
            print(json.dumps(reply), flush=True)
        if options == "long":
            reply["message"] = "x" * 1000000
        if options == "exit":
            print("gave up", file=sys.stderr)
            sys.exit(3)
        if options.startswith("murder "):
            murder(options.split()[1])
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
        if options.startswith("says "):
            key, value = options.split()[1:]
            reply[key] = json.loads(value)
        if options == "no toi":
            del reply["toi"]
    print(json.dumps(reply), flush=True)
