#!/usr/bin/env python3
"""A controller of the automated vehicle as a process of its own.

Reads a view a line, answers a decision a line; see env/vehicle/external.cpp for the fields. The
step is repeated in the answer, so that both cannot get out of step. One process drives in many
tests: each begins with a line `reset` and ends with a line `end`, which has no answer. It brakes
gently for whoever is in its lane within 30 m, and fully within 8 m.
"""
import json
import sys


def in_lane(actor, lane):
    left, right = actor["sides"]
    return right > lane[0] and left < lane[1]


for line in sys.stdin:
    view = json.loads(line)
    if "end" in view:
        continue
    if "reset" in view:  # what was remembered of the test before would be forgotten here
        print(json.dumps({"step": view["step"]}), flush=True)
        continue
    gaps = [a["gap"] for a in view["actors"] if a["gap"] > 0 and in_lane(a, view["lane"])]
    gaps += [stop["gap"] for stop in view["stop_lines"] if stop["closed"] and stop["gap"] > 0]
    gap = min(gaps, default=1e9)
    if gap < 8:
        acceleration = -8
    elif gap < 30:
        acceleration = -2
    else:
        acceleration = 2
    print(json.dumps({"step": view["step"], "acceleration": acceleration}), flush=True)
