#!/usr/bin/env python3
"""Mars, seven by seven: robot r1 looks for garbage and brings it to r2, which burns it. The run is over when all is burnt."""
import random
import sys

sys.path.append(sys.path[0] + "/..")        # where jaywalk_world.py is
from jaywalk_world import World, boxed      # noqa: E402

SIZE = 7
GARBAGE = [(3, 0), (6, 0), (1, 2), (0, 5), (6, 6)]


class Mars(World):
    tick_ms = 200
    picture_every = 20
    PERCEPTS = {"pos(Robot,X,Y)": "where r1 and r2 are; everybody sees this", "garbage(Robot)": "there is garbage where it is"}
    ACTIONS = {"next(slot)": "r1 goes to the next cell, row by row", "move_towards(X,Y)": "r1 goes one cell nearer",
               "pick(garb)": "r1 picks the garbage up, which fails to do so at most twice in a row",
               "drop(garb)": "r1 puts down what it carries", "burn(garb)": "r2 burns the garbage where it is"}

    def init(self, agents, seed):
        self.random = random.Random(seed)
        self.garbage = set(GARBAGE)
        self.at = {"r1": (0, 0), "r2": (SIZE // 2, SIZE // 2)}
        self.carrying, self.burnt, self.slips = False, 0, 0

    def percepts(self, agent):
        return [f"pos({robot},{x},{y})" for robot, (x, y) in self.at.items()] + [
            f"garbage({robot})" for robot, cell in self.at.items() if cell in self.garbage]

    def act(self, agent, name, args):
        x, y = here = self.at["r1"]
        match [name, *args]:
            case ["next", "slot"]:
                if here != (SIZE - 1, SIZE - 1):
                    self.at["r1"] = (x + 1, y) if x + 1 < SIZE else (0, y + 1)
            case ["move_towards", to_x, to_y]:
                self.at["r1"] = (x + (to_x > x) - (to_x < x), y + (to_y > y) - (to_y < y))
            case ["pick", "garb"]:
                if here in self.garbage:
                    self.slips = 0 if self.slips == 2 or self.random.random() < 0.5 else self.slips + 1
                    if self.slips == 0:
                        self.garbage.remove(here)
                        self.carrying = True
            case ["drop", "garb"]:
                if self.carrying:
                    self.garbage.add(here)
                    self.carrying = False
            case ["burn", "garb"]:
                if self.at["r2"] in self.garbage:
                    self.garbage.remove(self.at["r2"])
                    self.burnt += 1
            case _:
                return super().act(agent, name, args)

    def finished(self):
        return self.burnt == len(GARBAGE) or super().finished()

    def picture(self):
        marks = {cell: "g" for cell in self.garbage} | {self.at["r2"]: "2"} | {self.at["r1"]: "1"}
        return boxed(["".join(marks.get((x, y), ".").center(3) for x in range(SIZE)) for y in range(SIZE)],
                     f"1: robot r1{', with garbage' if self.carrying else ''}", "2: robot r2", "g: garbage",
                     f"burnt: {self.burnt} of {len(GARBAGE)}")


Mars().run()
