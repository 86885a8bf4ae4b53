#!/usr/bin/env python3
"""9. Search: a system under test of your own. It gets a road and answers how badly it drove there.

  jaywalk search examples/09_search.yaml

This one does not drive: its answer is the sharpest bend of the road. Call your simulator instead.
"""
import json
import math
import sys


def sharpest_bend(points):
    """The largest change of direction on a metre of the road, in radians."""
    ways = [(math.atan2(b[1] - a[1], b[0] - a[0]), math.dist(a, b)) for a, b in zip(points, points[1:])]
    return max(abs(math.remainder(next_way - way, math.tau)) / metres
               for (way, metres), (next_way, _) in zip(ways, ways[1:]))


for line in sys.stdin:
    test = json.loads(line)            # {"test": 0, "road_points": [[100, 10], [100, 25], ...], ...}
    answer = {"test": test["test"], "bend": sharpest_bend(test["road_points"])}
    print(json.dumps(answer), flush=True)
