# SPDX-License-Identifier: Apache-2.0
"""The environments of Gymnasium and PettingZoo: their own checkers where they are installed, and their documented
contracts in any case (https://gymnasium.farama.org/api/env, https://pettingzoo.farama.org/api/parallel)."""
import sys
import types
import unittest

try:
    import numpy
except ImportError:
    print("skipped: there is no numpy")
    sys.exit(77)

try:
    import gymnasium
    from gymnasium.utils.env_checker import check_env
except ImportError:
    check_env = None

    class Env:
        """What jaywalk.gym uses of gymnasium.Env."""

        def reset(self, *, seed=None, options=None):
            if seed is not None or not hasattr(self, "np_random"):
                self.np_random = numpy.random.default_rng(seed)

    class Box:
        def __init__(self, low, high, shape, dtype):
            self.low, self.high, self.shape, self.dtype = low, high, shape, numpy.dtype(dtype)

        def contains(self, value):
            is_within = bool(((self.low <= value) & (value <= self.high)).all())
            return value.shape == self.shape and value.dtype == self.dtype and is_within

    class Discrete:
        def __init__(self, n):
            self.n = n

    gymnasium = types.ModuleType("gymnasium")
    gymnasium.Env = Env
    gymnasium.spaces = types.SimpleNamespace(Box=Box, Discrete=Discrete)
    sys.modules["gymnasium"] = gymnasium

try:
    from pettingzoo.test import parallel_api_test
except ImportError:
    parallel_api_test = None
    sys.modules["pettingzoo"] = types.SimpleNamespace(ParallelEnv=object)

from jaywalk.crossing import ACTIONS  # noqa: E402
from jaywalk.gym import CrossingEnv  # noqa: E402
from jaywalk.pettingzoo import crossing_v0  # noqa: E402


def played(env, seed, choose):
    """The observations, rewards and last info of an episode."""
    seen, info = env.reset(seed=seed)
    observations, rewards = [seen], []
    terminated = False
    while not terminated:
        seen, reward, terminated, truncated, info = env.step(choose(seen))
        observations.append(seen)
        rewards.append(reward)
        assert truncated is False and env.observation_space.contains(seen)
    return numpy.array(observations), rewards, info


class GymTest(unittest.TestCase):
    @unittest.skipIf(check_env is None, "Gymnasium is not installed")
    def test_passes_gymnasiums_own_checker(self):
        check_env(CrossingEnv(), skip_render_check=True)

    def test_gives_the_same_episode_for_the_same_seed(self):
        env = CrossingEnv()
        first = played(env, 5, lambda seen: 1)
        again = played(env, 5, lambda seen: 1)
        other = played(env, 6, lambda seen: 1)
        numpy.testing.assert_array_equal(first[0], again[0])
        self.assertEqual(first[1], again[1])
        self.assertFalse(numpy.array_equal(first[0][0], other[0][0]))

    def test_rewards_are_the_scenarios_score(self):
        env = CrossingEnv()
        outcomes = set()
        for seed in range(40):
            _, rewards, info = played(env, seed, lambda seen: ACTIONS.index("move(right)"))
            self.assertAlmostEqual(sum(rewards), env._episode.result["scores"][0])
            self.assertEqual(info["succeeded"], info["ended_by"] == "precondition")
            outcomes.add(info["succeeded"])
        self.assertEqual(outcomes, {True, False})

    def test_shows_where_the_agent_is(self):
        env = CrossingEnv(render_mode="ansi")
        env.reset(seed=1)
        self.assertRegex(env.render(), r"tick\(1\) at\(\d+,\d+\) av\(-?\d+\)")

    def test_is_for_the_crossing(self):
        with self.assertRaisesRegex(ValueError, "expected a scenario of the crossing, found 'motorway'"):
            CrossingEnv("motorway")


def played_together(env, seed):
    """The observations and the sums of the rewards of an episode in which all walk to the right."""
    seen, infos = env.reset(seed=seed)
    assert set(seen) == set(infos) == set(env.agents) == set(env.possible_agents)
    history = [seen]
    sums = dict.fromkeys(env.agents, 0.0)
    while env.agents:
        acting = list(env.agents)
        seen, rewards, terminated, truncated, infos = env.step(dict.fromkeys(acting, ACTIONS.index("move(right)")))
        for said in (seen, rewards, terminated, truncated, infos):
            assert set(said) == set(acting)
        for agent in acting:
            assert env.observation_space(agent).contains(seen[agent])
            sums[agent] += rewards[agent]
        assert env.agents == [agent for agent in acting if not terminated[agent]]
        history.append(seen)
    return history, sums


class PettingZooTest(unittest.TestCase):
    @unittest.skipIf(parallel_api_test is None, "PettingZoo is not installed")
    def test_passes_pettingzoos_own_test(self):
        parallel_api_test(crossing_v0.parallel_env(agents=3), num_cycles=100)

    def test_moves_all_agents_at_once(self):
        env = crossing_v0.parallel_env(agents=3)
        history, sums = played_together(env, 5)
        numpy.testing.assert_almost_equal(list(sums.values()), env._episode.result["scores"])
        again, _ = played_together(env, 5)
        self.assertEqual(len(history), len(again))
        for seen, repeated in zip(history, again):
            for agent in env.possible_agents:
                numpy.testing.assert_array_equal(seen[agent], repeated[agent])
        self.assertEqual(len({tuple(each) for each in history[0].values()}), 3)


if __name__ == "__main__":
    unittest.main()
