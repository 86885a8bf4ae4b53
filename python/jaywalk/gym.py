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

from jaywalk.crossing import ACTIONS, HIGHEST, LOWEST, crossing, observation


class CrossingEnv(gymnasium.Env):
    """One pedestrian in a crossing scenario.

    Observation: float32 of the own row and cell, the AV's cell less the own, and its speed in cells per tick, each
    divided by the size of the grid. Action: the number of one of `jaywalk.crossing.ACTIONS`. Reward: what the step adds
    to the scenario's score (rewards less costs). Terminated: the test has ended. Each reset begins another test, which
    the seed decides.
    """

    metadata = {"render_modes": ["ansi"], "render_fps": 2}

    def __init__(self, scenario: Any = "paper", render_mode: Optional[str] = None):
        self.scenario = crossing(scenario)
        self.render_mode = render_mode
        self.observation_space = gymnasium.spaces.Box(
            numpy.array(LOWEST, numpy.float32), numpy.array(HIGHEST, numpy.float32), (len(LOWEST),), numpy.float32
        )
        self.action_space = gymnasium.spaces.Discrete(len(ACTIONS))
        self._episode: Any = None

    def reset(self, *, seed: Optional[int] = None, options: Optional[dict] = None):
        super().reset(seed=seed)
        test_seed = int(self.np_random.integers(2**31))
        self._episode = self.scenario.episode(seed=test_seed)
        self._score = 0.0
        return observation(self._episode, 0), {"seed": test_seed}

    def step(self, action):
        (failure,) = self._episode.step(ACTIONS[int(action)])
        result = self._episode.result
        (score,) = result["scores"]
        reward, self._score = score - self._score, score
        info = {"failed": failure is not None, "succeeded": result["succeeded"], "ended_by": result["ended_by"]}
        return observation(self._episode, 0), float(reward), self._episode.is_finished, False, info

    def render(self):
        if self.render_mode != "ansi":
            return None
        return " ".join(map(str, self._episode.percepts()[:3]))
