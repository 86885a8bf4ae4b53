# SPDX-License-Identifier: Apache-2.0
"""The environment of Gymnasium: its own checker where Gymnasium is installed, and its documented contract in any case
(https://gymnasium.farama.org/api/env)."""
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
            self.shape, self.dtype = shape, numpy.dtype(dtype)

        def contains(self, value):
            return value.shape == self.shape and value.dtype == self.dtype

    class Discrete:
        def __init__(self, n):
            self.n = n

    gymnasium = types.ModuleType("gymnasium")
    gymnasium.Env = Env
    gymnasium.spaces = types.SimpleNamespace(Box=Box, Discrete=Discrete)
    sys.modules["gymnasium"] = gymnasium

from jaywalk.gym import ACTIONS, CrossingEnv  # noqa: E402


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
        for seed in range(20):
            _, rewards, info = played(env, seed, lambda seen: ACTIONS.index("move(right)"))
            self.assertAlmostEqual(sum(rewards), env._episode.result["scores"][0])
            self.assertEqual(info["succeeded"], info["ended_by"] == "precondition")

    def test_shows_where_the_agent_is(self):
        env = CrossingEnv(render_mode="ansi")
        env.reset(seed=1)
        self.assertRegex(env.render(), r"tick\(1\) at\(\d+,\d+\) av\(-?\d+\)")

    def test_is_for_the_crossing(self):
        with self.assertRaisesRegex(ValueError, "expected a scenario of the crossing, found 'motorway'"):
            CrossingEnv("motorway")


if __name__ == "__main__":
    unittest.main()
