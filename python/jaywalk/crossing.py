# SPDX-License-Identifier: Apache-2.0
"""What the environments of jaywalk.gym and jaywalk.pettingzoo have in common."""
from __future__ import annotations

from typing import Any

import numpy

from jaywalk.bench import Episode, Scenario, load_scenario

#: The actions by their numbers.
ACTIONS = ("stay", "move(left)", "move(right)", "move(forward)", "move(back)")
#: The smallest and the greatest observation: row and cell of the grid, the AV's cell less the own, its speed.
LOWEST = (0, 0, -2, 0)
HIGHEST = (1, 1, 2, 1)


def crossing(scenario: Any) -> Scenario:
    found = scenario if isinstance(scenario, Scenario) else load_scenario(scenario)
    if found.world != "crossing":
        raise ValueError(f"expected a scenario of the crossing, found '{found.world}'")
    return found


def observation(episode: Episode, agent: int) -> numpy.ndarray:
    """Lengths and speeds as shares of the grid's."""
    seen = {each.functor: each.args for each in episode.percepts(agent)}
    rows, cells = seen["grid"]
    row, cell = seen["at"]
    values = (row / rows, cell / cells, (seen["av"][0] - cell) / cells, seen["av_speed"][0] / cells)
    return numpy.clip(numpy.array(values, numpy.float32), LOWEST, HIGHEST).astype(numpy.float32)
