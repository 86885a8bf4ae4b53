#!/usr/bin/env python3
"""6. Your own automated vehicle (AV): a program that is asked for an acceleration in each period.

  jaywalk run examples/06_own_av.yaml --watch

Jaywalk writes what the AV sees as a line of JSON: among others its `speed`, the rows of its `lane`
from left to right, and for each of the `actors` the `gap` from the AV's front and its two `sides`,
all in metres. The answer is a line of JSON, too, in m/s2.
"""
import json
import sys

for line in sys.stdin:
    view = json.loads(line)
    left, right = view["lane"]
    gap = min((actor["gap"] for actor in view["actors"] if actor["gap"] > 0
               and actor["sides"][1] > left and actor["sides"][0] < right), default=1000)
    braking = view["speed"] ** 2 / (2 * max(0.1, gap - 2))      # to stop 2 m before a pedestrian
    acceleration = -min(8, braking) if braking > 1 else 1.5
    print(json.dumps({"step": view["step"], "acceleration": acceleration}), flush=True)
