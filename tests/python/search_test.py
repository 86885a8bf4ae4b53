# SPDX-License-Identifier: Apache-2.0
"""Search from Python."""
import contextlib
import io
import random
import unittest

import jaywalk


def distance(x, y):
    return abs(x - 7) + abs(y + 2)


SPACE = {"x": (0, 10), "y": (-5, 5)}
SCALE = {"harmless": 10, "worst": 0.5, "fails_at": 1}


class Narrowing(jaywalk.Generator):
    """Draws around the best input so far."""

    def __init__(self, dimension, seed):
        super().__init__(dimension, seed)
        self.random = random.Random(seed)
        self.best = ([0.0] * dimension, -1.0)

    def ask(self, is_valid, spent):
        while True:
            wanted = [min(1, max(-1, self.random.gauss(each, 0.3))) for each in self.best[0]]
            if is_valid(wanted):
                return wanted

    def tell(self, input, fitness, failed):
        if fitness > self.best[1]:
            self.best = (list(input), fitness)


class SearchTest(unittest.TestCase):
    def test_finds_the_inputs_of_a_function_that_fail(self):
        found = jaywalk.search(distance, SPACE, generator=["random", "prospect"], budget=100, seed=1, **SCALE)
        self.assertEqual(len(found.rows), 200)
        self.assertTrue(found.is_complete)
        self.assertTrue(found.failures)
        for row in found.rows:
            self.assertEqual(row["value"], distance(**row["input"]))
            self.assertEqual(row["failed"], row["value"] <= 0.5)
        self.assertEqual(set(found.tests_to_first_failure), {("random", 0), ("prospect", 0)})

    def test_depends_on_the_seed_alone(self):
        def rows(**options):
            return jaywalk.search(distance, SPACE, generator=["random", "graft"], budget=40, repetitions=3, **SCALE, **options).rows

        self.assertEqual(rows(seed=5), rows(seed=5, threads=3))
        self.assertNotEqual(rows(seed=5), rows(seed=6))

    def test_takes_spaces_in_order_and_constraints(self):
        def why_invalid(values):
            return "the first is the greater one" if values[0] > values[1] else None

        found = jaywalk.search(sum, [(0, 1), (0, 1)], generator="random", budget=50, worst=2, why_invalid=why_invalid)
        self.assertTrue(all(row["input"][0] <= row["input"][1] for row in found.rows))

    def test_gives_signals_as_lists_of_pieces(self):
        def worst(gain, brake):
            self.assertIsInstance(gain, float)
            self.assertEqual(len(brake), 3)
            self.assertTrue(all(10 <= each <= 20 for each in brake))
            return max(brake) * gain

        space = {"gain": (0, 1), "brake": {"range": (10, 20), "pieces": 3}}
        found = jaywalk.search(worst, space, generator=["random", "graft"], budget=30, harmless=0, worst=20)
        self.assertEqual(len(found.rows), 60)
        for row in found.rows:
            self.assertFalse(row["error"])
            self.assertEqual(row["value"], worst(**row["input"]))
        with self.assertRaisesRegex(ValueError, "a signal has a range and pieces; brake has range"):
            jaywalk.search(worst, {"gain": (0, 1), "brake": {"range": (10, 20)}}, budget=1)
        with self.assertRaisesRegex(ValueError, "pieces of brake"):
            jaywalk.search(worst, {"gain": (0, 1), "brake": {"range": (10, 20), "pieces": 0}}, budget=1)

    def test_runs_generators_that_are_classes_beside_its_own(self):
        found = jaywalk.search(distance, SPACE, generator=["random", Narrowing], budget=150, repetitions=5, **SCALE)
        first = found.tests_to_first_failure
        self.assertEqual({name for name, _ in first}, {"random", "Narrowing"})
        failures = {name: sum(row["failed"] for row in found.rows if row["generator"] == name) for name in ("random", "Narrowing")}
        self.assertGreater(failures["Narrowing"], failures["random"])

    def test_errs_one_test_for_an_exception_of_the_function(self):
        def sometimes(x, y):
            if x > 5:
                raise ValueError("too far")
            return x

        with contextlib.redirect_stderr(io.StringIO()) as shown:
            found = jaywalk.search(sometimes, SPACE, generator="random", budget=40)
        errors = [row for row in found.rows if row["error"]]
        self.assertTrue(0 < len(errors) < 40)
        self.assertTrue(all(row["value"] is None and not row["failed"] for row in errors))
        self.assertEqual(shown.getvalue().count("ValueError: too far"), 1)

    def test_passes_on_exceptions_of_generators_and_interrupts(self):
        class Broken(Narrowing):
            def ask(self, is_valid, spent):
                raise RuntimeError("no idea")

        with self.assertRaisesRegex(RuntimeError, "no idea"):
            jaywalk.search(distance, SPACE, generator=Broken, budget=10, **SCALE)

        class Wordy(Narrowing):
            def ask(self, is_valid, spent):
                return ["far"]

        with self.assertRaisesRegex(TypeError, "no list of numbers"):
            jaywalk.search(distance, SPACE, generator=Wordy, budget=10, **SCALE)

        def interrupted(x, y):
            raise KeyboardInterrupt

        with self.assertRaises(KeyboardInterrupt):
            jaywalk.search(interrupted, SPACE, budget=10)

    def test_refuses_what_makes_no_search(self):
        with self.assertRaisesRegex(ValueError, "range of x is empty"):
            jaywalk.search(distance, {"x": (1, 1), "y": (0, 1)}, budget=1)
        with self.assertRaisesRegex(TypeError, "a space and a budget"):
            jaywalk.search(distance, SPACE)
        with self.assertRaises(jaywalk.Error) as caught:
            jaywalk.search(distance, SPACE, generator="prospct", budget=1)
        self.assertIn("there is no generator 'prospct'", str(caught.exception))

    def test_runs_searches_that_are_files(self):
        found = jaywalk.search("lane-keeping", generator="random", budget=3, repetitions=1)
        self.assertEqual(len(found.rows), 3)
        self.assertTrue(all(0 <= row["fitness"] <= 1 for row in found.rows))


if __name__ == "__main__":
    unittest.main()
