# SPDX-License-Identifier: Apache-2.0
"""The crossing as an environment of PettingZoo's parallel API (https://pettingzoo.farama.org): several pedestrians that
learn together. Needs pettingzoo, gymnasium and numpy.

    from jaywalk.pettingzoo import crossing_v0
    env = crossing_v0.parallel_env(agents=3)
"""
from __future__ import annotations

import functools
from types import SimpleNamespace
from typing import Any, Optional

try:
    import gymnasium
    import numpy
    import pettingzoo
except ImportError:
    raise ImportError("jaywalk.pettingzoo needs pettingzoo, gymnasium and numpy: pip install pettingzoo") from None

from jaywalk.crossing import ACTIONS, HIGHEST, LOWEST, crossing, observation


class CrossingParallelEnv(pettingzoo.ParallelEnv):
    """The pedestrians p1, p2, … of a crossing scenario; observations, actions and rewards are those of
    jaywalk.gym.CrossingEnv, for each of them."""

    metadata = {"name": "crossing_v0", "render_modes": ["ansi"], "is_parallelizable": True}

    def __init__(self, scenario: Any = "paper", agents: int = 2, render_mode: Optional[str] = None):
        self.scenario = crossing(scenario)
        self.render_mode = render_mode
        self.possible_agents = [f"p{number + 1}" for number in range(agents)]
        self.agents: list[str] = []
        self._random = numpy.random.default_rng()
        self._episode: Any = None

    @functools.lru_cache(maxsize=None)
    def observation_space(self, agent: str):
        lowest, highest = (numpy.array(bound, numpy.float32) for bound in (LOWEST, HIGHEST))
        return gymnasium.spaces.Box(lowest, highest, (len(LOWEST),), numpy.float32)

    @functools.lru_cache(maxsize=None)
    def action_space(self, agent: str):
        return gymnasium.spaces.Discrete(len(ACTIONS))

    def reset(self, seed: Optional[int] = None, options: Optional[dict] = None):
        if seed is not None:
            self._random = numpy.random.default_rng(seed)
        self._episode = self.scenario.episode(agents=len(self.possible_agents), seed=int(self._random.integers(2**31)))
        self.agents = list(self.possible_agents)
        self._scores = [0.0] * len(self.agents)
        return self._look(), {agent: {} for agent in self.agents}

    def step(self, actions):
        chosen = [ACTIONS[int(actions[agent])] for agent in self.agents]
        failures = self._episode.step(*chosen)
        result = self._episode.result
        rewards = {
            agent: float(now - before) for agent, now, before in zip(self.agents, result["scores"], self._scores)
        }
        self._scores = result["scores"]
        seen = self._look()
        infos = {agent: {"failed": failure is not None} for agent, failure in zip(self.agents, failures)}
        terminations = {agent: self._episode.is_finished for agent in self.agents}
        truncations = {agent: False for agent in self.agents}
        if self._episode.is_finished:
            self.agents = []
        return seen, rewards, terminations, truncations, infos

    def render(self):
        if self.render_mode != "ansi":
            return None
        return "\n".join(" ".join(map(str, self._episode.percepts(i)[:3])) for i in range(len(self.possible_agents)))

    def close(self):
        """Nothing is open."""

    def _look(self):
        return {agent: observation(self._episode, i) for i, agent in enumerate(self.possible_agents)}


crossing_v0 = SimpleNamespace(parallel_env=CrossingParallelEnv)
