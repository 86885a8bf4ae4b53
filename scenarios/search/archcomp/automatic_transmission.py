#!/usr/bin/env python3
"""A car with an automatic transmission, after the description of the benchmark AT of ARCH-COMP's falsification category.

The model is ours, and simpler: an engine whose torque is a parabola of its speed, a torque converter, four gears with a
shift schedule, wheels with road load and brake. It reads throttle (%) and brake (ft lb), pieces of equal length, and
answers speed (mph), rpm and gear. Torques are in ft lb, inertias in ft lb s2.
"""
import json
import sys

STEP = 0.1                                        # s
RATIOS = (2.4, 1.45, 1.0, 0.68)
FINAL_DRIVE = 3.2
RPM_PER_MPH = 13.5                                # of the wheels
UP = ((12, 43), (22, 74), (38, 112))              # mph at which it shifts up, without throttle and at full throttle
DOWN = ((6, 26), (13, 46), (26, 76))              # and down
SHIFT_DELAY = 0.15                                # s for which the schedule has to ask for it
ENGINE_INERTIA, WHEEL_INERTIA = 0.8, 90.0
RPM_PER_RAD_S = 9.55


def scheduled(gear, speed, throttle):
    """The gear that the schedule asks for, from 0."""
    if gear < 3 and speed > UP[gear][0] + (UP[gear][1] - UP[gear][0]) * throttle / 100:
        return gear + 1
    if gear > 0 and speed < DOWN[gear - 1][0] + (DOWN[gear - 1][1] - DOWN[gear - 1][0]) * throttle / 100:
        return gear - 1
    return gear


def drive(throttles, brakes, duration):
    ticks = round(duration / STEP)
    rows, speed, rpm, gear, asked_for = [], 0.0, 1000.0, 0, 0.0
    for tick in range(ticks + 1):
        rows.append((round(tick * STEP, 6), speed, rpm, gear + 1))
        throttle = throttles[min(tick * len(throttles) // ticks, len(throttles) - 1)]
        brake = brakes[min(tick * len(brakes) // ticks, len(brakes) - 1)]
        wanted = scheduled(gear, speed, throttle)
        asked_for = asked_for + STEP if wanted != gear else 0.0
        if asked_for > SHIFT_DELAY:
            gear, asked_for = wanted, 0.0
        slip = min(speed * RPM_PER_MPH * FINAL_DRIVE * RATIOS[gear] / rpm, 1.5)    # above 1 the wheels drive the engine
        pump = (rpm / 150) ** 2 * (1 - slip ** 3)
        engine = throttle / 100 * 250 * (1 - ((rpm - 3000) / 4200) ** 2) - 0.006 * (rpm - 800)
        wheels = pump * max(2 - slip, 1.0) * RATIOS[gear] * FINAL_DRIVE
        load = 18 + 0.012 * speed ** 2 + 1.2 * brake
        rpm = min(max(rpm + STEP * (engine - pump) / ENGINE_INERTIA * RPM_PER_RAD_S, 600.0), 6000.0)
        speed = max(speed + STEP * (wheels - load) / WHEEL_INERTIA * RPM_PER_RAD_S / RPM_PER_MPH, 0.0)
    return dict(zip(("time", "speed", "rpm", "gear"), zip(*rows)))


if __name__ == "__main__":
    for line in sys.stdin:
        test = json.loads(line)
        answer = drive(test["inputs"]["throttle"], test["inputs"]["brake"], test["duration_s"])
        print(json.dumps({"test": test["test"], **answer}), flush=True)
