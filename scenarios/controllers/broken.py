#!/usr/bin/env python3
"""Careful and competent drivers with a fault, as controllers of one's own.

    broken.py FAULT     broken.py list

`healthy` drives as the model careful-competent does (UN Regulation No. 157). The faults are none of
those that `jaywalk list defects` shows: they were invented before anybody had seen how the behaviours of
agents/crossing fare against them, and the behaviours were not changed for them. The lines that are read
and answered are those of gentle.py; `world.av.period: 0.05` asks as often as the model decides.
"""
import json
import sys

COMFORTABLE, STRONGEST, JERK = 2, 0.774 * 9.80665, 12.65
PERCEPTION, DELAY, ROUNDING = 0.4, 0.75, 1e-9


def over(actor, lane, shift=0.0):
    left, right = actor["sides"]
    return right + shift > lane[0] + 1e-6 and left + shift < lane[1] - 1e-6


class Healthy:
    """no fault"""

    delay = DELAY
    resumes = 2

    def __init__(self):
        self.since, self.lines = {}, {}
        self.stops_at, self.braking = None, 0

    def decide(self, view):
        actors = self.look(view, view["actors"])
        risks = [a["id"] for a in actors if a["gap"] >= -0.01 and over(a, view["lane"])]
        self.since = {i: self.since.get(i, view["time"]) for i in risks}
        return self.act(view, self.drive(view))

    def look(self, view, actors):
        return actors

    def act(self, view, wanted):
        return wanted

    def drive(self, view):
        time, period = view["time"], view["period"]
        line = self.line(view)
        perceived = min(self.since.values(), default=float("inf")) + PERCEPTION
        free = min(max(perceived + self.delay - time, 0), period)
        change = 0
        if free > 0:
            if line is None and time + ROUNDING < perceived:
                wanted = (view["cruise"] - view["speed"]) / period
                change = min(max(wanted, -self.resumes), self.resumes) * free
            change -= self.press(line or 0, free)
        if free < period:
            change -= self.press(STRONGEST, period - free)
        return change / period

    def press(self, wanted, seconds):
        before = min(self.braking, wanted)
        grows = min((wanted - before) / JERK, seconds)
        self.braking = before + JERK * grows
        return (before + self.braking) / 2 * grows + self.braking * (seconds - grows)

    def line(self, view):
        """The braking for a closed line; None without a need, which standing at one is not."""
        gaps = [s["gap"] for s in view["stop_lines"] if s["closed"] and s["gap"] >= -1]
        places = {round(view["front"] + gap, 3): gap for gap in gaps}
        self.lines = {place: self.lines.get(place, view["time"]) for place in places}
        reacts = [view["time"] + ROUNDING >= t + PERCEPTION + DELAY for t in self.lines.values()]
        place = min((p for p, ready in zip(places, reacts) if ready), default=None)
        stops_at, self.stops_at = self.stops_at, None
        if place is None:
            return None
        room, speed = places[place], view["speed"]
        needed = 0 if speed <= 0 else speed**2 / (2 * room) if room > 0 else float("inf")
        if place != stops_at and needed < COMFORTABLE:
            return None
        self.stops_at = place
        return min(needed, STRONGEST)


class ThinPeople(Healthy):
    """takes people for the middle tenth of a metre of their width"""

    def look(self, view, actors):
        middles = [(sum(a["sides"]) / 2, a) for a in actors]
        return [dict(a, sides=[m - 0.05, m + 0.05]) for m, a in middles]


class Flicker(Healthy):
    """loses everybody for 0.1 s in every 1.5 s and takes them for new ones"""

    def look(self, view, actors):
        return [] if view["time"] % 1.5 < 0.1 else actors


class Pitching(Healthy):
    """does not see further than 8 m while it brakes hard: its nose dips"""

    def look(self, view, actors):
        return [a for a in actors if self.braking < 4 or a["gap"] < 8]


class Glare(Healthy):
    """sees nobody while its front is between 20 and 34 m of the road: the sun"""

    def look(self, view, actors):
        return [] if 20 < view["front"] < 34 else actors


class Sleeps(Healthy):
    """sees nobody for 1 s when it has stood for 2.5 s, again and again: it saves energy"""

    def __init__(self):
        super().__init__()
        self.stood = 0

    def look(self, view, actors):
        self.stood = self.stood + view["period"] if view["speed"] < 0.1 else 0
        return [] if self.stood % 3.5 > 2.5 else actors


class AfterYou(Healthy):
    """takes who has stood still for 1 s to let it pass, until they have walked for 1 s"""

    def __init__(self):
        super().__init__()
        self.stands, self.lets_pass = {}, {}

    def look(self, view, actors):
        for a in actors:
            still = abs(a["ahead"]) + abs(a["right"]) < 0.1
            self.stands[a["id"]] = self.stands.get(a["id"], 0) + view["period"] if still else 0
            if self.stands[a["id"]] > 1:
                self.lets_pass[a["id"]] = view["time"]
        return [a for a in actors if view["time"] - self.lets_pass.get(a["id"], -9) > 1]


class LooksAhead(Healthy):
    """drives by where people will be in 0.7 s, not by where they are"""

    def look(self, view, actors):
        return [dict(a, sides=[s + 0.7 * a["right"] for s in a["sides"]]) for a in actors]


class Retreating(Healthy):
    """ignores who walks away from the middle of its body"""

    def look(self, view, actors):
        middle = sum(view["body"]) / 2
        return [a for a in actors if (sum(a["sides"]) / 2 - middle) * a["right"] <= 0]


class CryWolf(Healthy):
    """brakes 0.6 s later for 10 s after somebody whom it braked for has gone back or out"""

    def __init__(self):
        super().__init__()
        self.braked, self.alarm = False, -99

    def look(self, view, actors):
        self.braked = self.braked or self.braking > 1
        if self.braked and not self.since:
            self.braked, self.alarm = False, view["time"]
        self.delay = DELAY + (0.6 if view["time"] - self.alarm < 10 else 0)
        return actors


class BrakeBudget(Healthy):
    """has air for two brakings only, the third has half of the force"""

    def __init__(self):
        super().__init__()
        self.brakings, self.on = 0, False

    def act(self, view, wanted):
        on = wanted < -0.5
        self.brakings += on and not self.on
        self.on = on
        return wanted / 2 if on and self.brakings > 2 else wanted


class JustEnough(Healthy):
    """brakes no harder than it takes to stop right before the nearest in its lane, as it reckons"""

    def look(self, view, actors):
        gaps = [a["gap"] for a in actors if a["gap"] > 0 and over(a, view["lane"])]
        self.gap = min(gaps, default=None)
        return actors

    def act(self, view, wanted):
        if self.gap is None or wanted > -0.5:
            return wanted
        return max(wanted, -view["speed"] ** 2 / (2 * self.gap))


class SoftStop(Healthy):
    """below 2.5 m/s brakes with 0.8 m/s2 only, so that nobody is shaken"""

    def act(self, view, wanted):
        return max(wanted, -0.8) if view["speed"] < 2.5 else wanted


class HastyStart(Healthy):
    """picks up speed with 5 m/s2 and cannot brake before it is back at 6 m/s"""

    def __init__(self):
        super().__init__()
        self.starts = False

    def act(self, view, wanted):
        self.starts = view["speed"] < 6 and (self.starts or (view["speed"] < 0.5 and wanted > 0.5))
        return 5 if self.starts else wanted


class MemoryLeak(Healthy):
    """needs 0.03 s longer to react for every second that it has driven"""

    def look(self, view, actors):
        self.delay = DELAY + 0.03 * view["time"]
        return actors


class Restarts(Healthy):
    """is away for 0.9 s in every 6 s; the pedals stay as they are"""

    last = 0

    def act(self, view, wanted):
        self.last = self.last if view["time"] % 6 > 5.1 else wanted
        return self.last


class PulsedBrakes(Healthy):
    """releases the brake for 0.1 s in every 0.3 s of braking"""

    def act(self, view, wanted):
        return 0 if wanted < -0.5 and view["time"] % 0.3 > 0.19 else wanted


class StickyThrottle(Healthy):
    """goes on accelerating for 1.25 s after it has let go of the throttle"""

    def __init__(self):
        super().__init__()
        self.gained = -99

    def act(self, view, wanted):
        if wanted > 0.5:
            self.gained = view["time"]
        return 2 if wanted <= 0 and view["time"] - self.gained < 1.25 else wanted


class Busy(Healthy):
    """while it brakes for somebody it notices nobody else (two people at least)"""

    target = None

    def look(self, view, actors):
        seen = [a for a in actors if a["gap"] >= -0.01 and over(a, view["lane"])]
        if self.target not in [a["id"] for a in seen]:
            self.target = min(seen, key=lambda a: a["gap"])["id"] if seen else None
        return [a for a in actors if a["id"] == self.target]


class Courteous(Healthy):
    """lets one person pass for each stop: the next one is not seen for 2 s (two people at least)"""

    def __init__(self):
        super().__init__()
        self.who, self.passed = None, (None, -99)

    def look(self, view, actors):
        for i in self.since:
            if view["speed"] < 0.5:
                self.who = i
        if self.who is not None and self.who not in self.since:
            self.passed, self.who = (self.who, view["time"]), None
        late = view["time"] - self.passed[1] < 2
        return [a for a in actors if not late or a["id"] == self.passed[0]]


FAULTS = {
    "".join("-" + c.lower() if c.isupper() else c for c in each.__name__)[1:]: each
    for each in [Healthy] + Healthy.__subclasses__()
}


def main():
    name = sys.argv[1] if len(sys.argv) == 2 else ""
    if name == "list":
        for each, driver in FAULTS.items():
            print(f"{each:16} {driver.__doc__}")
        return
    if name not in FAULTS:
        sys.exit(f"error: expected one of {', '.join(FAULTS)}, or list")
    for text in sys.stdin:
        line = json.loads(text)
        if "end" in line:
            continue
        answer = {"step": line["step"]}
        if "reset" in line:
            driver = FAULTS[name]()
        else:
            answer["acceleration"] = driver.decide(line)
        print(json.dumps(answer), flush=True)


main()
