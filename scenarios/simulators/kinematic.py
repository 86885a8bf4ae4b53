#!/usr/bin/env python3
"""A simulator of the automated vehicle (AV) and an oncoming car, to copy and change.

It speaks the simulator protocol (docs/guides/own_simulator.md): a line of JSON for each question, a
line for each answer. `Road` is the simulation, `serve` the protocol; a simulator of one's own keeps
`serve` and has another `Road`. Metres, seconds, radians; x to the AV's right, y along the road,
headings counter-clockwise from x.
"""
import json
import math
import sys

AHEAD = math.pi / 2


class Car:
    """Drives along the road; what it wants to accelerate by takes a moment to come about."""

    LAG = 0.2  # s, of engine and brakes
    SPEED_UP, COMFORTABLE, HARDEST = 2.0, 3.0, 8.0  # m/s^2

    def __init__(self, x, y, heading, speed, length, width):
        self.x, self.y, self.heading, self.speed = x, y, heading, speed
        self.length, self.width = length, width
        self.wanted_speed = speed
        self.acceleration = 0.0

    @property
    def way(self):
        return 1 if math.sin(self.heading) > 0 else -1

    def gap_to(self, y):
        """From the car's front to a place along the road, positive ahead."""
        return self.way * (y - self.y) - self.length / 2

    def drive(self, gap, dt, standoff=2.0):
        """One step, with a free way of `gap` metres: without a need to brake, to its speed as in
        the Intelligent Driver Model; else evenly, to stop `standoff` before."""
        wanted = self.SPEED_UP * (1 - (self.speed / max(self.wanted_speed, 0.1)) ** 4)
        needed = self.speed**2 / (2 * max(gap - standoff, 0.1))
        if needed >= self.COMFORTABLE or (self.speed < 0.5 and gap < standoff + 1):
            wanted = -needed
        wanted = max(-self.HARDEST, min(self.SPEED_UP, wanted))
        self.acceleration += (wanted - self.acceleration) * min(1.0, dt / self.LAG)
        before = self.speed
        self.speed = max(0.0, before + self.acceleration * dt)
        if self.speed == 0.0:
            self.acceleration = 0.0
        self.y += self.way * (before + self.speed) / 2 * dt

    def state(self):
        return {"x": self.x, "y": self.y, "heading": self.heading, "speed": self.speed,
                "acceleration": self.acceleration}


class Road:
    NAME, VERSION = "kinematic", "1.0"
    LOOK_AHEAD = 1.0  # s: whoever is in the way by then counts

    def __init__(self, reset):
        self.time = 0.0
        self.crosswalks = reset["road"]["crosswalks"]
        self.sizes = [(a["kind"], a["length"], a["width"]) for a in reset["actors"]]
        av = reset["av"]
        self.av = Car(av["x"], av["y"], av["heading"], av["speed"], av["length"], av["width"])
        self.standoff = av["standoff"]
        self.length = reset["road"]["length"]
        self.traffic = []
        for band in reset["road"]["bands"]:
            if band["kind"] == "lane" and band["oncoming"]:
                middle = sum(band["across"]) / 2
                self.traffic.append(Car(middle, self.length, -AHEAD, av["cruise"], 4.5, 1.8))
                break

    def described_traffic(self):
        return [{"name": f"car{i + 1}", "kind": "vehicle", "length": c.length, "width": c.width,
                 **self.car_state(c)} for i, c in enumerate(self.traffic)]

    def car_state(self, car):
        return {**car.state(), "present": -10 < car.y <= self.length}

    def scene(self):
        return {"time": self.time, "av": self.av.state(),
                "traffic": [self.car_state(car) for car in self.traffic]}

    def step(self, dt, actors, signals):
        colours = {each["crosswalk"]: each["colour"] for each in signals}
        for car in [self.av, *self.traffic]:
            gap = min(self.free_way(car, actors), self.stop_line(car, actors, colours))
            car.drive(gap, dt, self.standoff)
        self.time += dt

    def free_way(self, car, actors):
        """Metres until the first of those who are, or soon will be, in the way."""
        gap = math.inf
        for (kind, length, width), actor in zip(self.sizes, actors):
            if kind == "signal":
                continue
            reach = (car.width + max(length, width)) / 2
            side = math.cos(actor["heading"]) * actor["speed"]
            first, last = sorted([actor["x"], actor["x"] + side * self.LOOK_AHEAD])
            if first - reach < car.x < last + reach:
                ahead = car.gap_to(actor["y"]) - max(length, width) / 2
                if ahead > -car.length:
                    gap = min(gap, max(ahead, 0.0))
        return gap

    def stop_line(self, car, actors, colours):
        gap = math.inf
        for index, crosswalk in enumerate(self.crosswalks):
            if crosswalk["kind"] == "zebra":
                closed = any(self.is_on(part, kind, actor) for part in crosswalk["parts"]
                             for (kind, _, _), actor in zip(self.sizes, actors))
            else:
                closed = colours.get(index, "green") != "green"
            ahead = car.gap_to(crosswalk["begins"])
            if closed and car is self.av and ahead > 0:
                gap = min(gap, ahead)
        return gap

    @staticmethod
    def is_on(part, kind, actor):
        across, along = part["across"], part["along"]
        return (kind == "pedestrian" and across[0] <= actor["x"] < across[1]
                and along[0] <= actor["y"] < along[1])


def serve(simulation):
    """Answers until the input ends. Every answer repeats the numbers of its question."""
    road = None
    for line in sys.stdin:
        message = json.loads(line)
        kind = message["type"]
        if kind == "bye":
            return
        answer = {"step": message["step"]}
        if kind == "hello":
            answer.update(protocol=1, name=simulation.NAME, version=simulation.VERSION,
                          deterministic=True)
        elif kind == "reset":
            road = simulation(message)
            answer.update(road.scene(), test=message["test"], traffic=road.described_traffic())
        elif kind == "step":
            road.step(message["dt"], message["actors"], message["signals"])
            answer.update(road.scene(), test=message["test"])
        else:
            answer.update(test=message.get("test", 0), error=f"there is no message '{kind}'")
        print(json.dumps(answer), flush=True)


if __name__ == "__main__":
    serve(Road)
