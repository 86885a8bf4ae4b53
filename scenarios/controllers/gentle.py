#!/usr/bin/env python3
"""A controller of the automated vehicle as a process of its own.

Reads a view a line, answers a decision a line; docs/reference/controller_protocol.md has the
fields. The step is repeated in the answer, so that both cannot get out of step. One process drives in many
tests: each begins with a line `reset`, whose answer names the fields that the controller reads, and
ends with a line `end`, which has no answer. It brakes gently for whoever is in its lane within
30 m, and fully within 8 m.
"""
import json
import sys

READS = ["actors.gap", "actors.sides", "lane", "stop_lines"]


def in_lane(actor, lane):
    left, right = actor["sides"]
    return right > lane[0] and left < lane[1]


def decide(view):
    gaps = [a["gap"] for a in view["actors"] if a["gap"] > 0 and in_lane(a, view["lane"])]
    gaps += [stop["gap"] for stop in view["stop_lines"] if stop["closed"] and stop["gap"] > 0]
    gap = min(gaps, default=1e9)
    return -8 if gap < 8 else -2 if gap < 30 else 2


def answer(text):
    sys.stdout.write(text + "\n")
    sys.stdout.flush()


for line in sys.stdin:
    view = json.loads(line)
    if "end" in view:
        continue
    if "reset" in view:  # what was remembered of the test before would be forgotten here
        answer(json.dumps({"step": view["step"], "reads": READS}))
        continue
    answer(f'{{"step": {view["step"]}, "acceleration": {decide(view)}}}')
