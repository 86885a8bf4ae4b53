#!/usr/bin/env python3
"""A system under test in a program of its own: how a simulator is attached to `jaywalk search`.

Reads a test as one line of JSON on standard input and answers with one line on standard output:

    {"test": 0, "map_size": 200, "road_points": [[100, 10], [100, 25], ...]}
    {"test": 0, "max_oob": 0.42, "min_oob_distance_m": 0.3, "sim_time": 11.7}

`test` is the number of the test, repeated so that no answer is taken for another test's. `sim_time` is in
seconds; the other names are those that the experiment lists under `measures`. What cannot
be executed is answered with {"error": "why"}. Anything else on standard output would be nonsense, so
logs belong on standard error.

This example does not simulate: it guesses from the sharpest turn. Put the call of BeamNG.tech, CARLA or
another simulator in the place of `execute`.
"""

import json
import math
import sys


def headings(points):
    """The direction of each stretch of the road, in radians."""
    return [math.atan2(by - ay, bx - ax) for (ax, ay), (bx, by) in zip(points, points[1:])]


def execute(points):
    """The outcome of driving the road, as a dictionary that becomes the answer."""
    directions = headings(points)
    turns = [abs(math.remainder(b - a, math.tau)) for a, b in zip(directions, directions[1:])]
    length = sum(math.dist(a, b) for a, b in zip(points, points[1:]))
    sharpest = max(turns, default=0.0)
    return {
        "max_oob": min(1.0, sharpest / 1.1),
        "min_oob_distance_m": 2.0 - 4.0 * sharpest,
        "sim_time": length / 15.0,
    }


def main():
    for line in sys.stdin:
        test = json.loads(line)
        try:
            answer = execute(test["road_points"])
        except Exception as error:  # one test fails, the search goes on
            answer = {"error": str(error)}
        print(json.dumps({"test": test["test"], **answer}), flush=True)


if __name__ == "__main__":
    main()
