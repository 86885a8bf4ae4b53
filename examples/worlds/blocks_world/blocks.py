#!/usr/bin/env python3
"""Seven blocks on a table. The top block of a tower can be moved onto another tower or the table.

The run is over five seconds after the last move."""
import sys

sys.path.append(sys.path[0] + "/..")    # where jaywalk_world.py is
from jaywalk_world import World         # noqa: E402


class Blocks(World):
    tick_ms = 500
    PERCEPTS = {"on(Block,Place)": "the block is directly on this block, or on the table"}
    ACTIONS = {"move(Block,Place)": "put the block on another or on the table; neither may have a block on it"}

    def init(self, agents, seed):
        self.towers = [list("cba"), list("ed"), list("gf")]     # from the table up
        self.moves = []

    def percepts(self, agent):
        return [f"on({block},{below})" for tower in self.towers for below, block in zip(["table", *tower], tower)]

    def act(self, agent, name, args):
        if name != "move" or len(args) != 2:
            return super().act(agent, name, args)
        block, place = args
        tops = {tower[-1]: tower for tower in self.towers}
        for each in args:
            if each not in tops and each != "table":
                return f"{each} is not the top of a tower"
        if block in ("table", place):
            return f"{block} cannot be moved to {place}"
        if place == "table":
            self.towers.append([])
        tops.get(place, self.towers[-1]).append(tops[block].pop())
        self.towers = [tower for tower in self.towers if tower]
        self.moves.append(f"{block} onto {place}")

    def finished(self):
        return self.idle_ms >= 5000

    def picture(self):
        height = max(map(len, self.towers))
        rows = ["".join(f"  {tower[level] if level < len(tower) else ' '}" for tower in self.towers).rstrip()
                for level in reversed(range(height))]
        return "\n".join([*rows, "-" * 24, f"move {len(self.moves)}: {self.moves[-1]}" if self.moves else "the beginning"])


Blocks().run()
