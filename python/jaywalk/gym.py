# SPDX-License-Identifier: Apache-2.0
"""The crossing as an environment of Gymnasium (https://gymnasium.farama.org): a pedestrian that learns to step in front
of the AV. Needs gymnasium and numpy."""
from __future__ import annotations

from typing import Any, Optional

try:
    import gymnasium
    import numpy
except ImportError:
    raise ImportError("jaywalk.gym needs gymnasium and numpy: pip install gymnasium") from None

from jaywalk.bench import Scenario, load_scenario

ACTIONS = ("stay", "move(left)", "move(right)", "move(forward)", "move(back)")


class CrossingEnv(gymnasium.Env):
    """One pedestrian in a crossing scenario.

    Observation: float32 of row, cell, the AV's cell less the own, its speed (cells per tick), all divided by the size
    of the grid. Action: 0 to 4, ACTIONS. Reward: what the scenario's score says of the step (rewards less costs).
    Terminated: the precondition of the assertion was met, or the AV has reached the end of its road. Each reset draws
    another test of the scenario from the seed.
    """

    metadata = {"render_modes": ["ansi"], "render_fps": 2}

    def __init__(self, scenario: Any = "paper", render_mode: Optional[str] = None):
        self.scenario = scenario if isinstance(scenario, Scenario) else load_scenario(scenario)
        if self.scenario.world != "crossing":
            raise ValueError(f"expected a scenario of the crossing, found '{self.scenario.world}'")
        self.render_mode = render_mode
        self.observation_space = gymnasium.spaces.Box(-numpy.inf, numpy.inf, (4,), numpy.float32)
        self.action_space = gymnasium.spaces.Discrete(len(ACTIONS))
        self._episode: Any = None

    def reset(self, *, seed: Optional[int] = None, options: Optional[dict] = None):
        super().reset(seed=seed)
        test_seed = int(self.np_random.integers(2**31))
        self._episode = self.scenario.episode(seed=test_seed)
        self._score = 0.0
        return self._look(), {"seed": test_seed}

    def step(self, action):
        (failure,) = self._episode.step(ACTIONS[int(action)])
        result = self._episode.result
        (score,) = result["scores"]
        reward, self._score = score - self._score, score
        info = {"failed": failure is not None, "succeeded": result["succeeded"], "ended_by": result["ended_by"]}
        return self._look(), float(reward), self._episode.is_finished, False, info

    def render(self):
        if self.render_mode != "ansi":
            return None
        return " ".join(map(str, self._episode.percepts()[:3]))

    def _look(self):
        seen = {each.functor: each.args for each in self._episode.percepts()}
        rows, cells = seen["grid"]
        row, cell = seen["at"]
        return numpy.array(
            [row / rows, cell / cells, (seen["av"][0] - cell) / cells, seen["av_speed"][0] / cells], numpy.float32
        )
