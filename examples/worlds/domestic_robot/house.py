#!/usr/bin/env python3
"""A house with a fridge, an owner who likes beer, a robot that may bring it, and a supermarket that delivers more.

The run is over a minute after the last action."""
import sys

sys.path.append(sys.path[0] + "/..")        # where jaywalk_world.py is
from jaywalk_world import World, boxed      # noqa: E402

SIZE = 7
PLACES = {"fridge": (0, 0), "owner": (SIZE - 1, SIZE - 1)}


class House(World):
    tick_ms = 100
    picture_every = 20
    PERCEPTS = {"at(robot,Place)": "the robot is at the fridge or the owner; it alone sees that",
                "stock(beer,N)": "what is in the fridge; the robot sees it while the fridge is open",
                "has(owner,beer)": "the owner's glass is not empty; the owner and the robot see that"}
    ACTIONS = {"move_towards(Place)": "one cell nearer to the fridge or the owner", "open(fridge)": "fails if it is open",
                "close(fridge)": "fails if it is closed",
               "get(beer)": "take a beer out of the open fridge", "hand_in(beer)": "give the owner a beer of ten sips",
               "sip(beer)": "drink one of them",
                "deliver(beer,N)": "bring N beers into the fridge; takes four seconds"}

    def init(self, agents, seed):
        self.robot = (SIZE // 2, SIZE // 2)
        self.open = self.carrying = False
        self.beers, self.sips, self.served = 2, 0, 0

    def percepts(self, agent):
        glass = ["has(owner,beer)"] if self.sips else []
        if agent == "robot":
            return [f"at(robot,{place})" for place, cell in PLACES.items() if cell == self.robot] + (
                [f"stock(beer,{self.beers})"] if self.open else []) + glass
        return glass if agent == "owner" else []

    def act(self, agent, name, args):
        match [name, *args]:
            case ["move_towards", place] if place in PLACES:
                self.robot = tuple(here + (there > here) - (there < here)
                                   for here, there in zip(self.robot, PLACES[place]))
            case ["open", "fridge"]:
                if self.open:
                    return "the fridge is open"
                self.open = True
            case ["close", "fridge"]:
                if not self.open:
                    return "the fridge is closed"
                self.open = False
            case ["get", "beer"]:
                if not self.open or not self.beers or self.carrying:
                    return "no beer can be taken"
                self.beers, self.carrying = self.beers - 1, True
            case ["hand_in", "beer"]:
                if not self.carrying:
                    return "the robot carries no beer"
                self.carrying, self.sips, self.served = False, 10, self.served + 1
            case ["sip", "beer"]:
                if not self.sips:
                    return "the glass is empty"
                self.sips -= 1
            case ["deliver", "beer", number]:
                return self.deliver(number)
            case _:
                return super().act(agent, name, args)

    def deliver(self, number):
        for _ in range(40):
            yield
        self.beers += number

    def picture(self):
        marks = {cell: place[0].upper() for place, cell in PLACES.items()} | {self.robot: "R"}
        return boxed(["".join(marks.get((x, y), ".").center(3) for x in range(SIZE)) for y in range(SIZE)],
                     f"Fridge: {self.beers} beers, {'open' if self.open else 'closed'}",
                     f"Robot{': carries a beer' if self.carrying else ''}",
                     f"Owner: beer {self.served}, {self.sips} sips left")


House().run()
