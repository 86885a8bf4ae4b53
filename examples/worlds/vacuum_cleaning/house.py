#!/usr/bin/env python3
"""Four rooms in which dirt falls, and a vacuum cleaner: 1 2 above, 3 4 below. The run lasts a minute."""
import random
import sys

sys.path.append(sys.path[0] + "/..")        # where jaywalk_world.py is
from jaywalk_world import World, boxed      # noqa: E402

WAYS = {"left": (-1, 0), "right": (1, 0), "up": (0, -1), "down": (0, 1)}


class House(World):
    tick_ms = 500
    picture_every = 10
    PERCEPTS = {"pos(Room)": "the cleaner is in this room, 1 to 4", "dirty": "there is dirt in it", "clean": "there is none"}
    ACTIONS = {"suck": "remove the dirt", **dict.fromkeys(WAYS, "go to the room there; without one, stay")}

    def init(self, agents, seed):
        self.random = random.Random(seed)
        self.dirty = {(x, y) for x in (0, 1) for y in (0, 1)}
        self.at = (0, 0)
        self.sucked = self.in_vain = 0

    def percepts(self, agent):
        x, y = self.at
        return [f"pos({1 + x + 2 * y})", "dirty" if self.at in self.dirty else "clean"]

    def act(self, agent, name, args):
        if name == "suck":
            self.sucked += self.at in self.dirty
            self.in_vain += self.at not in self.dirty
            self.dirty.discard(self.at)
        elif name in WAYS:
            self.at = tuple(max(0, min(1, here + step)) for here, step in zip(self.at, WAYS[name]))
        else:
            return super().act(agent, name, args)

    def tick(self):
        if self.ticks % 2 == 0 and self.random.random() < 0.2:        # once a second
            self.dirty.add((self.random.randrange(2), self.random.randrange(2)))

    def finished(self):
        return self.ticks >= 119

    def picture(self):
        room = {at: ("robot" if at == self.at else "").center(7) + ("dirt" if at in self.dirty else "").center(6)
                for at in ((0, 0), (1, 0), (0, 1), (1, 1))}
        rows = [f"{room[0, y]}|{room[1, y]}" for y in (0, 1)]
        return boxed([rows[0], "-" * 13 + "+" + "-" * 13, rows[1]],
                     f"{self.ticks / 2:g} s", f"cleaned {self.sucked} times", f"sucked in vain {self.in_vain} times")


House().run()
