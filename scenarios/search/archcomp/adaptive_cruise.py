#!/usr/bin/env python3
"""Cars behind each other with adaptive cruise control, after the descriptions of ARCH-COMP's benchmarks of following cars.

The model is ours: the first car does what the test says, the acceleration that its driver asks for in pieces of equal
length (m/s2); each further one keeps a distance of STANDSTILL and HEADWAY to the car ahead. Acceleration follows the
demand with a lag and is limited. It answers the gaps between the cars (m) and the last one's speed (m/s).
"""
import json
import sys

STEP = 0.2                       # s
FOLLOWERS = 3
STANDSTILL, HEADWAY = 5.0, 1.0   # m, s
LAG = 0.6                        # s
GAP_GAIN, SPEED_GAIN = 0.25, 0.6
MOST, LEAST = 2.0, -3.5          # m/s2
SPEED_LIMIT = 35.0               # m/s


def controlled(gap, speed, ahead):
    """What the controller of a car asks for."""
    return GAP_GAIN * (gap - STANDSTILL - HEADWAY * speed) + SPEED_GAIN * (ahead - speed)


def drive(demands, duration):
    ticks = round(duration / STEP)
    rows = []
    speeds = [20.0] * (FOLLOWERS + 1)
    accelerations = [0.0] * (FOLLOWERS + 1)
    gaps = [STANDSTILL + HEADWAY * 20.0] * FOLLOWERS
    for tick in range(ticks + 1):
        rows.append((round(tick * STEP, 6), *gaps, speeds[-1]))
        asked = [demands[min(tick * len(demands) // ticks, len(demands) - 1)]]
        asked += [controlled(gap, speed, ahead) for gap, speed, ahead in zip(gaps, speeds[1:], speeds)]
        before = speeds
        accelerations = [a + STEP / LAG * (min(max(wanted, LEAST), MOST) - a) for a, wanted in zip(accelerations, asked)]
        speeds = [min(max(speed + STEP * a, 0.0), SPEED_LIMIT) for speed, a in zip(speeds, accelerations)]
        gaps = [gap + STEP * (ahead - speed) for gap, ahead, speed in zip(gaps, before, before[1:])]
    return dict(zip(("time", *(f"gap{i + 1}" for i in range(FOLLOWERS)), "speed"), zip(*rows)))


if __name__ == "__main__":
    for line in sys.stdin:
        test = json.loads(line)
        print(json.dumps({"test": test["test"], **drive(test["inputs"]["demand"], test["duration_s"])}), flush=True)
