"""play(path): a small player of the OpenSCENARIO that Jaywalk writes, made after the standard and not
after the program: entities on polylines with times, set in motion by simulation time or by a time to
collision, until the stop trigger. Returns the name of the first entity that the AV touches, or None,
and the farthest that anybody was moved at once when its trajectory began, in metres.

    player.py STORE FOLDER   plays every file of the folder and compares the outcomes with the store's;
                             if the player esmini is installed, it plays them, too
"""
import glob
import math
import os
import re
import shutil
import sqlite3
import subprocess
import sys
import xml.etree.ElementTree as xml

STEP = 0.01  # s


def pose(position):
    at = position.find("WorldPosition") if position.tag == "Position" else position
    return float(at.get("x")), float(at.get("y")), float(at.get("h"))


class Entity:
    def __init__(self, scenario_object):
        self.name = scenario_object.get("name")
        center = scenario_object.find(".//BoundingBox/Center")
        size = scenario_object.find(".//BoundingBox/Dimensions")
        self.ahead = float(center.get("x"))
        self.length, self.width = float(size.get("length")), float(size.get("width"))
        self.pose = (0.0, 0.0, 0.0)
        self.speed = 0.0
        self.way = []
        self.condition = None
        self.absolute = False
        self.begun = None

    def box(self):
        x, y, h = self.pose
        c, s = math.cos(h), math.sin(h)
        x, y = x + self.ahead * c, y + self.ahead * s
        return [(x + c * l * self.length / 2 - s * w * self.width / 2,
                 y + s * l * self.length / 2 + c * w * self.width / 2)
                for l, w in ((-1, -1), (1, -1), (1, 1), (-1, 1))]

    def at(self, time):
        last = self.way[0]
        for vertex in self.way[1:]:
            if time < vertex[0]:
                share = (time - last[0]) / (vertex[0] - last[0])
                return tuple(a + share * (b - a) for a, b in zip(last[1:3], vertex[1:3])) + (last[3],)
            last = vertex
        return last[1:]


def overlap(first, second):
    """Two convex polygons: no edge of either has the other on its outer side."""
    for polygon, other in ((first, second), (second, first)):
        for (ax, ay), (bx, by) in zip(polygon, polygon[1:] + polygon[:1]):
            if all((bx - ax) * (y - ay) - (by - ay) * (x - ax) < 0 for x, y in other):
                return False
    return True


def distance(first, second):
    if overlap(first, second):
        return 0.0
    best = math.inf
    for polygon, other in ((first, second), (second, first)):
        for (ax, ay), (bx, by) in zip(polygon, polygon[1:] + polygon[:1]):
            for x, y in other:
                t = ((x - ax) * (bx - ax) + (y - ay) * (by - ay)) / ((bx - ax) ** 2 + (by - ay) ** 2)
                t = min(max(t, 0.0), 1.0)
                best = min(best, math.hypot(x - ax - t * (bx - ax), y - ay - t * (by - ay)))
    return best


def holds(condition, time, av, entities):
    clock = condition.find(".//SimulationTimeCondition")
    if clock is not None:
        return time > float(clock.get("value"))
    ttc = condition.find(".//TimeToCollisionCondition")
    if ttc is not None:
        target = entities[ttc.find(".//EntityRef").get("entityRef")]
        gap = distance(av.box(), target.box())
        return av.speed > 0 and 0 < gap and gap / av.speed < float(ttc.get("value"))
    collision = condition.find(".//CollisionCondition/EntityRef")
    return collision is not None and overlap(av.box(), entities[collision.get("entityRef")].box())


def load(root):
    entities = {each.get("name"): Entity(each) for each in root.iter("ScenarioObject")}
    for private in root.iter("Private"):
        entity = entities[private.get("entityRef")]
        entity.pose = pose(private.find(".//Position"))
        speed = private.find(".//AbsoluteTargetSpeed")
        entity.speed = float(speed.get("value")) if speed is not None else 0.0
    for group in root.iter("ManeuverGroup"):
        entity = entities[group.find("Actors/EntityRef").get("entityRef")]
        entity.condition = group.find(".//Event/StartTrigger")
        entity.absolute = group.find(".//Timing").get("domainAbsoluteRelative") == "absolute"
        entity.way = [(float(v.get("time")),) + pose(v.find("Position")) for v in group.iter("Vertex")]
    return entities


def play(path):
    root = xml.parse(path).getroot()
    entities = load(root)
    av = next(iter(entities.values()))
    over = root.find("Storyboard/StopTrigger").findall("ConditionGroup")
    jump = 0.0
    hit = None
    for step in range(1_000_000):
        time = step * STEP
        for entity in entities.values():
            if not entity.way:
                continue
            if entity.begun is None and holds(entity.condition, time, av, entities):
                entity.begun = 0.0 if entity.absolute else time
                start = entity.at(time - entity.begun)
                jump = max(jump, math.dist(start[:2], entity.pose[:2]))
            if entity.begun is not None:
                before = entity.pose
                entity.pose = entity.at(time - entity.begun)
                if step > 0:
                    entity.speed = math.dist(before[:2], entity.pose[:2]) / STEP
        for entity in entities.values():
            if hit is None and entity is not av and overlap(av.box(), entity.box()):
                hit = entity.name
        if any(holds(group, time, av, entities) for group in over):
            return hit, jump
    raise AssertionError(f"{path} never ends")


def outcomes(store):
    query = ("SELECT behaviour || '-' || agents || '-test-' || number, EXISTS (SELECT 1 FROM events e "
             "WHERE e.test_id = t.id AND e.kind = 'collision') FROM tests t")
    return dict(sqlite3.connect(store).execute(query).fetchall())


def esmini_finds(path):
    run = subprocess.run(["esmini", "--osc", path, "--headless", "--fixed_timestep", str(STEP), "--disable_log",
                          "--collision", "--traj_filter", "0"], capture_output=True, text=True, timeout=60)
    return bool(re.search(r"ollision between (av|\S+ and av)\b", run.stdout + run.stderr))


def main(store, folder):
    stored = outcomes(store)
    wrong, played = [], 0
    for path in sorted(glob.glob(f"{folder}/*-test-*.xosc")):
        test = re.sub(r"(-reactive)?\.xosc$", "", os.path.basename(path))
        hit, jump = play(path)
        played += 1
        if bool(hit) != bool(stored[test]):
            wrong.append(f"{path}: {'hits ' + hit if hit else 'no collision'}, the store says otherwise")
        if jump > 1e-6:
            wrong.append(f"{path}: somebody jumps {jump:.2f} m when its trajectory begins")
        if shutil.which("esmini") and esmini_finds(path) != bool(stored[test]):
            wrong.append(f"{path}: esmini finds another outcome than the store")
    print("\n".join(wrong))
    print(f"{played} files played, {sum(map(bool, stored.values()))} of {len(stored)} tests with a collision")
    return 1 if wrong or not played else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
