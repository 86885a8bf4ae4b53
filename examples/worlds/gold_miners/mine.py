#!/usr/bin/env python3
"""Four miners bring the gold of a mountain to their depot. They see only the cells around them. The seed hides the gold."""
import random
import sys

sys.path.append(sys.path[0] + "/..")        # where jaywalk_world.py is
from jaywalk_world import World, boxed      # noqa: E402

MAP = """
1...............#......................2
................#.......................
....#####.......#.......####............
........#...................#...........
........#...................#...........
........................................
............#...........................
............#......##..##......#........
............#......#....#......#........
...................#.D..#......#........
.....####..........##.###...............
........#...............................
........#.......................#####...
................#...............#.......
................#.......................
3...............#......................4
""".split()
WIDTH, HEIGHT, NUGGETS = len(MAP[0]), len(MAP), 12
CELLS = {(x, y): mark for y, row in enumerate(MAP) for x, mark in enumerate(row)}
PLACES = {mark: cell for cell, mark in CELLS.items()}
WAYS = {"left": (-1, 0), "right": (1, 0), "up": (0, -1), "down": (0, 1), "skip": (0, 0)}


class Mine(World):
    tick_ms = 50
    picture_every = 50
    PERCEPTS = {"gsize(Simulation,Width,Height)": "the size of the map; everybody sees this",
                "depot(Simulation,X,Y)": "where gold is brought to; everybody sees this",
                "end_of_simulation(Simulation,Result)": "all gold is in the depot; everybody sees this",
                "pos(X,Y)": "where the miner is", "carrying_gold": "the miner carries gold",
                "cell(X,Y,What)": "obstacle, gold or ally: what is in the nine cells around the miner, itself included"}
    ACTIONS = {"do(What)": "left, right, up or down, into a free cell; skip; pick gold up; drop it"}

    def init(self, agents, seed):
        miners = (agent for agent in agents if agent.startswith("miner"))
        self.at = {miner: PLACES[number] for number, miner in zip("1234", miners)}
        self.gold = set(random.Random(seed).sample([cell for cell, mark in CELLS.items() if mark == "."], NUGGETS))
        self.carrying, self.home = set(), 0

    def percepts(self, agent):
        seen = [f"gsize(1,{WIDTH},{HEIGHT})", "depot(1,{},{})".format(*PLACES["D"])]
        seen += ["end_of_simulation(1,0)"] * (self.home == NUGGETS) + ["carrying_gold"] * (agent in self.carrying)
        if agent not in self.at:
            return seen
        x, y = self.at[agent]
        around = [(x + right, y + down) for right in (-1, 0, 1) for down in (-1, 0, 1)]
        return seen + [f"pos({x},{y})"] + [
            f"cell({x},{y},{what})" for x, y in around
            for what, is_there in (("obstacle", CELLS.get((x, y)) == "#"), ("gold", (x, y) in self.gold),
                                   ("ally", (x, y) in self.at.values())) if is_there]

    def act(self, agent, name, args):
        here = self.at.get(agent)
        match [name, *args]:
            case ["do", way] if here and way in WAYS:
                there = tuple(old + step for old, step in zip(here, WAYS[way]))
                if CELLS.get(there, "#") != "#" and there not in self.at.values():
                    self.at[agent] = there
            case ["do", "pick"] if here:
                if here not in self.gold or agent in self.carrying:
                    return "no gold can be picked up"
                self.gold.remove(here)
                self.carrying.add(agent)
            case ["do", "drop"] if here:
                if agent not in self.carrying:
                    return "the miner carries no gold"
                self.carrying.remove(agent)
                if here == PLACES["D"]:
                    self.home += 1
                else:
                    self.gold.add(here)
            case _:
                return super().act(agent, name, args)

    def finished(self):
        return self.home == NUGGETS or super().finished()

    def picture(self):
        marks = {**{cell: mark if mark in "#D" else " " for cell, mark in CELLS.items()}, **dict.fromkeys(self.gold, "*"),
                 **{cell: agent[-1] for agent, cell in self.at.items()}}
        return boxed(["".join(marks[x, y] for x in range(WIDTH)) for y in range(HEIGHT)],
                     f"{self.ticks * self.tick_ms / 1000:g} s", "1 to 4: miners", "D: the depot", "*: gold",
                     f"{self.home} of {NUGGETS} home", f"{len(self.carrying)} carried")


Mine().run()
