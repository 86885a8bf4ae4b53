# SPDX-License-Identifier: Apache-2.0
"""Scenarios, comparisons, stores and AVs from Python."""
import contextlib
import io
import json
import os
import pathlib
import tempfile
import unittest

import jaywalk

CROSS = "!cross. +!cross : at(X,Y) & grid(R,C) & X < R-1 <- move(right); !cross. +!cross. -!cross <- stay; !cross."


class Careful(jaywalk.AV):
    def act(self, view):
        near = [each for each in view.actors if -1 < each.gap_m < 25 and each.kind == "pedestrian"]
        return -9.0 if near else 1.0


class ScenarioTest(unittest.TestCase):
    def test_compares_a_behaviour_that_is_a_text(self):
        scenario = jaywalk.load_scenario("paper", behaviours={"crosser": CROSS})
        results = scenario.compare(tests=20, agents=[1, 2])
        self.assertEqual([(row["behaviour"], row["agents"], row["tests"]) for row in results.rows],
                         [("crosser", 1, 20), ("crosser", 2, 20)])
        self.assertEqual(results.accuracy[("crosser", 1)], 100 * results.rows[0]["successes"] / 20)
        self.assertIn("crosser", str(results))
        self.assertIn("<td>crosser</td>", results._repr_html_())

    def test_gives_the_tables_of_a_store(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder, "100% #1?.gpkg")
            jaywalk.compare("rules_of_the_road", behaviours=["brink"], agents=1, tests=12, store=path)
            store = jaywalk.open(path)
            results = store.table()
            self.assertEqual(len(results), 12)
            self.assertEqual(list(results["succeeded"].astype(bool)), [test["succeeded"] for test in store.tests()])
            failed = store.table("assessments").query("verdict == 'fail'")
            self.assertGreater(len(failed), 0)
            for row in results.itertuples():
                names = list(failed[failed["test_id"] == row.id]["name"])
                self.assertEqual((row.failed or "").split(), names)
            with self.assertRaisesRegex(KeyError, "no table 'result'"):
                store.table("result")

    def test_counts_the_defects_that_a_behaviour_kills(self):
        behaviours = ["hunter", "random_behaviour"]
        results = jaywalk.compare("defects", behaviours=behaviours, agents=1, tests=40,
                                  defects=["short-range=12", "latency=0.9"])  # fmt: skip
        kills = results.kills
        self.assertEqual(list(kills["behaviour"]), ["hunter", "hunter", "random_behaviour", "random_behaviour"])
        self.assertEqual(set(kills["defect"]), {"short-range=12", "latency=0.9"})
        self.assertTrue((kills["tests"] == 40).all())
        self.assertTrue((kills["healthy_failures"] == 0).all())
        counted = kills.groupby("behaviour")["kills"].sum()
        self.assertGreater(counted["hunter"], counted["random_behaviour"])
        self.assertEqual(counted["hunter"], next(row["kills"] for row in json.loads(results.json)["kills"]["rows"] if row["behaviour"] == "hunter"))

    def test_counts_the_kills_of_an_own_av(self):
        results = jaywalk.compare("rules_of_the_road", behaviours=["random_behaviour"], agents=1, tests=30, av=Careful,
                                  defects="short-range=12")  # fmt: skip
        self.assertEqual(list(results.kills["tests"]), [30])
        self.assertGreater(results.kills["kills"][0], 0)

    def test_puts_defects_on_an_own_av_where_the_scenarios_never_brakes(self):
        options = {"behaviours": ["proximity"], "agents": 1, "tests": 5, "defects": "latency=0.9", "assertions": ["crossing"]}
        self.assertEqual(list(jaywalk.compare("paper", av=Careful, **options).kills["tests"]), [5])
        with self.assertRaisesRegex(jaywalk.Error, "no defect shows in it"):
            jaywalk.compare("paper", **options)

    def test_has_no_kills_without_defects(self):
        results = jaywalk.compare("rules_of_the_road", behaviours=["brink"], agents=1, tests=2)
        self.assertTrue(results.kills.empty)
        self.assertIn("defect", results.kills.columns)

    def test_refuses_defects_that_there_are_not(self):
        with self.assertRaisesRegex(jaywalk.Error, "did you mean 'latency'"):
            jaywalk.compare("rules_of_the_road", defects="latancy")

    def test_gives_the_same_results_for_any_number_of_threads(self):
        one = jaywalk.compare("paper", behaviours=["random_behaviour", "proximity"], tests=30, agents=2, threads=1)
        three = jaywalk.compare("paper", behaviours=["random_behaviour", "proximity"], tests=30, agents=2, threads=3)
        successes = [row["successes"] for row in one.rows]
        self.assertTrue(all(0 < each < 30 for each in successes), successes)
        self.assertEqual(successes, [row["successes"] for row in three.rows])

    def test_reports_progress_and_passes_its_exceptions_on(self):
        told = []
        jaywalk.compare("paper", behaviours="random_behaviour", tests=300, agents=5, progress=lambda *now: told.append(now))
        self.assertEqual(told[-1], (300, 300))

        def stop(done, total):
            raise KeyboardInterrupt

        with self.assertRaises(KeyboardInterrupt):
            jaywalk.compare("paper", behaviours="random_behaviour", tests=100000, agents=5, progress=stop)

    def test_runs_one_test_and_shows_it(self):
        test = jaywalk.load_scenario("paper").run("proximity", agents=2, test=1)
        self.assertEqual(test.actors[0], "av")
        columns = test.trajectory
        self.assertEqual(len(columns["x_m"]), 3 * (test.ticks + 1))
        self.assertEqual({len(column) for column in columns.values()}, {len(columns["tick"])})
        self.assertIn("<html", test.to_html())
        self.assertIn("iframe", test._repr_html_())
        again = jaywalk.load_scenario("paper").run("proximity", agents=2, test=1)
        self.assertEqual(again.trajectory, columns)

    def test_points_at_mistakes(self):
        with self.assertRaises(jaywalk.Error) as caught:
            jaywalk.load_scenario("paper", {"world.av.sped": 2})
        self.assertIn("did you mean", str(caught.exception))
        with self.assertRaises(jaywalk.Error) as caught:
            jaywalk.load_scenario("paper", behaviours={"mine": "!go.\n+!go <- move(."})
        self.assertRegex(str(caught.exception), r"mine\.asl:2:\d+: error")
        with self.assertRaisesRegex(ValueError, "a behaviour's name"):
            jaywalk.load_scenario("paper", behaviours={"../mine": "!go."})
        with self.assertRaises(jaywalk.Error):
            jaywalk.load_scenario("no such scenario")
        with self.assertRaisesRegex(TypeError, "a class derived from AV"):
            jaywalk.load_scenario("braking", av=jaywalk.AV())
        for options in ({"tests": 0}, {"agents": [1, 0]}, {"agents": 10**9}, {"threads": 10**6}, {"seed": -1}):
            (name,) = options
            with self.assertRaisesRegex(ValueError, f"{name}: expected a whole number"):
                jaywalk.compare("paper", **options)
        with self.assertRaises(jaywalk.Error) as caught:
            jaywalk.load_scenario("paper").run("proximty")
        self.assertIn("did you mean 'proximity'", str(caught.exception))
        with self.assertRaisesRegex(KeyError, "no measure 'acuracy'"):
            jaywalk.compare("paper", behaviours="random_behaviour", tests=1, agents=1).measure("acuracy")

    def test_keeps_tests_in_a_store(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder, "runs.gpkg")
            made = jaywalk.compare("paper", behaviours=["random_behaviour", "election"], tests=10, agents=[1, 3], store=path)
            store = jaywalk.open(path)
            self.assertEqual((len(store), store.is_complete), (40, True))
            self.assertEqual(store.comparison().rows, made.rows)
            failed = store.tests(behaviour="random_behaviour", agents=1, succeeded=False)
            self.assertTrue(failed)
            self.assertTrue(all(row["behaviour"] == "random_behaviour" and not row["succeeded"] for row in failed))
            test = store.test(store.tests(succeeded=True)[0]["id"])
            self.assertTrue(test.succeeded)
            self.assertIn("<html", test.to_html())
            with self.assertRaises(jaywalk.Error):
                store.test(41)
            with self.assertRaises(jaywalk.Error):
                store.tests(behaviour="elction")
            with self.assertRaises(jaywalk.Error):
                jaywalk.compare("paper", behaviours="random_behaviour", tests=10, agents=1, store=path)
        with self.assertRaises(jaywalk.Error):
            jaywalk.open("nowhere.gpkg")

    def test_gives_data_frames(self):
        try:
            import pandas
        except ImportError:
            self.skipTest("there is no pandas")
        frame = jaywalk.compare("paper", behaviours="random_behaviour", tests=10, agents=[1, 2]).to_dataframe()
        self.assertEqual(list(frame["agents"]), [1, 2])
        test = jaywalk.load_scenario("paper").run("random_behaviour")
        self.assertIsInstance(test.to_dataframe(), pandas.DataFrame)
        judged = jaywalk.judge(test.to_dataframe(), ["crossing"])
        self.assertTrue(judged.verdicts)

    def test_judges_a_drive_that_is_a_text(self):
        x = jaywalk.load_scenario("paper").run().trajectory["x_m"][0]
        rows = ["time,actor,kind,x,y"]
        for tick in range(11):
            rows += [f"{tick},av,vehicle,{x},{tick}", f"{tick},ann,pedestrian,{x + 6},5"]
        judged = jaywalk.judge("\n".join(rows) + "\n", ["crossing"])
        self.assertEqual((judged.ticks, judged.actors), (10, ["av", "ann"]))
        self.assertTrue(judged.verdicts)
        self.assertTrue(all(each.verdict in ("pass", "vacuous") for each in judged.verdicts.values()))
        with self.assertRaises(jaywalk.Error) as caught:
            jaywalk.judge("time,actor,kind,x\n0,av,vehicle,1\n")
        self.assertIn("y", str(caught.exception))


class Blind(jaywalk.AV):
    def act(self, view):
        return 1.0


class Careful(jaywalk.AV):
    def __init__(self):
        self.views = 0

    def act(self, view):
        self.views += 1
        ahead = [actor for actor in view.actors if 0 <= actor.gap_m < 40]
        return -9.0 if ahead else 1.0


class AVTest(unittest.TestCase):
    SCENARIO = "braking"

    def collisions(self, av):
        scenario = jaywalk.load_scenario(self.SCENARIO, av=av, behaviours="proximity")
        tests = [scenario.run(test=number) for number in range(10)]
        self.assertEqual([each.error for each in tests], [""] * 10)
        return sum(test.impact_mps is not None for test in tests)

    def test_drives_instead_of_the_scenarios(self):
        self.assertGreater(self.collisions(Blind), self.collisions(Careful))

    def test_drives_alike_on_any_number_of_threads(self):
        scenario = jaywalk.load_scenario(self.SCENARIO, av=Careful, behaviours="proximity")
        one, three = (
            scenario.compare(tests=10, agents=1, threads=threads, assertions=["crossing"]).rows[0] for threads in (1, 3)
        )
        compared = [name for name in one if "." in name or name in ("successes", "score")]
        self.assertTrue(any(0 < one[name] < 10 for name in compared if "." in name), one)
        self.assertEqual([one[name] for name in compared], [three[name] for name in compared])

    def test_errs_by_itself(self):
        class Broken(jaywalk.AV):
            def act(self, view):
                return 1 / 0

        class Mute(jaywalk.AV):
            def act(self, view):
                return None

        for av, why in ((Broken, "ZeroDivisionError"), (Mute, "no number")):
            with contextlib.redirect_stderr(io.StringIO()):
                test = jaywalk.load_scenario(self.SCENARIO, av=av).run()
            self.assertIn(why, test.error)

    def test_is_refused_where_it_has_no_meaning(self):
        with self.assertRaises(jaywalk.Error) as caught:
            jaywalk.load_scenario("paper", {"world.av.carry_over": True}, av=Careful)
        self.assertIn("carry", str(caught.exception))
        with tempfile.TemporaryDirectory() as folder:
            with self.assertRaises(jaywalk.Error) as caught:
                jaywalk.compare(self.SCENARIO, av=Careful, tests=1, agents=1, store=os.path.join(folder, "x.gpkg"))
            self.assertIn("a program's own AV", str(caught.exception))
            self.assertEqual(os.listdir(folder), [])


class EpisodeTest(unittest.TestCase):
    def test_is_driven_tick_by_tick(self):
        episode = jaywalk.load_scenario("paper").episode(agents=2, test=3)
        first = {each.functor: each.args for each in episode.percepts(1)}
        self.assertEqual(first["id"], (2,))
        reasons = episode.step("stay", "jump")
        self.assertIsNone(reasons[0])
        self.assertIn("unknown action", reasons[1])
        while not episode.is_finished:
            episode.step(None, "stay")
        result = episode.result
        self.assertEqual(len(result["scores"]), 2)
        self.assertTrue(result["ended_by"])
        with self.assertRaisesRegex(ValueError, "has ended"):
            episode.step(None, None)

    def test_is_the_test_that_agents_run_in(self):
        # An agent that walks to the right, once in Python and once in AgentSpeak.
        scenario = jaywalk.load_scenario("paper", behaviours={"right": "!s. +!s <- move(right); !s. -!s <- !s."})
        outcomes = set()
        for number in range(40):
            episode = scenario.episode(test=number)
            while not episode.is_finished:
                episode.step("move(right)")
            result = episode.result
            test = scenario.run(test=number)
            self.assertEqual((result["succeeded"], result["ticks"], result["scores"][0]), (test.succeeded, test.ticks, test.score))
            outcomes.add(test.succeeded)
        self.assertEqual(outcomes, {True, False})


if __name__ == "__main__":
    unittest.main()
