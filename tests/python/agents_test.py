# SPDX-License-Identifier: Apache-2.0
"""Agents from Python."""
import contextlib
import io
import threading
import unittest

import jaywalk
from jaywalk import Atom, Structure


class AgentsTest(unittest.TestCase):
    def setUp(self):
        self.lines = []
        self.logged = []

    def interpreter(self, **options):
        return jaywalk.Interpreter(print=self.lines.append, log=self.logged.append, **options)

    def test_prints_what_agents_print_and_says_how_the_run_ended(self):
        interpreter = self.interpreter()
        interpreter.add_agent("ann", "!count(3). +!count(0). +!count(N) <- .print(N); !count(N-1).")
        outcome = interpreter.run()
        self.assertEqual(self.lines, ["[ann] 3", "[ann] 2", "[ann] 1"])
        self.assertEqual(outcome.end, "idle")

    def test_keeps_each_kind_of_value_both_ways(self):
        interpreter = self.interpreter()
        agent = interpreter.add_agent("ann")
        values = [3, -0.25, 1e-7, "left", 'q"\n\t', Atom("left"), [1, [Atom("a")], []], Structure("p", (1, "x"))]
        for value in values:
            agent.believe(Structure("is", (value,)))
        found = [answer["X"] for answer in agent.ask("is(X)")]
        self.assertEqual(found, list(reversed(values)))
        self.assertEqual([type(each) for each in found], [type(each) for each in reversed(values)])

    def test_reads_beliefs_with_annotations(self):
        agent = self.interpreter().add_agent("ann", "~busy. speed(3)[source(radar)].")
        self.assertIn(Structure("~busy", (), (Structure("source", (Atom("self"),)),)), agent.beliefs)
        (speed,) = [each for each in agent.beliefs if each.functor == "speed"]
        self.assertEqual((speed.args, speed.source), ((3,), Atom("radar")))

    def test_takes_beliefs_and_goals_as_texts_or_structures(self):
        interpreter = self.interpreter()
        agent = interpreter.add_agent("ann", '+!greet(Who) : polite <- .print("hello, ", Who).')
        agent.believe("polite", source="bob")
        agent.achieve(Structure("greet", ("world",)))
        interpreter.run()
        self.assertEqual(self.lines, ["[ann] hello, world"])
        self.assertTrue(agent.holds("polite[source(bob)]"))
        agent.forget("polite", source="bob")
        self.assertFalse(agent.holds("polite"))

    def test_calls_functions_as_internal_actions(self):
        interpreter = self.interpreter()
        seen = []

        @interpreter.action("road.note")
        def note(what: Atom, number: float):
            seen.append((what, number))

        @interpreter.function("road.distance")
        def distance(speed: float):
            return speed**2 / 13

        @interpreter.function("road.path")
        def path():
            return "C:\\path"

        @interpreter.function("road.lane")
        def lanes():
            yield from (1, 2, 3)

        @interpreter.function("road.first")
        def first():
            yield 1
            raise ValueError("there is no second")

        agent = interpreter.add_agent(
            "ann", "!go. +!go : road.lane(L) & L > 1 <- road.distance(26, D); road.note(lane, L); road.note(m, D); road.path(P); +path(P). !f. +!f : road.first(N) <- road.note(first, N)."
        )
        interpreter.run()
        self.assertCountEqual(seen, [(Atom("first"), 1), (Atom("lane"), 2), (Atom("m"), 52)])
        self.assertEqual(agent.ask("path(P)"), [{"P": "C:\\path"}])

    def test_fails_actions_whose_function_returns_false_or_gets_another_type(self):
        interpreter = self.interpreter()

        @interpreter.action("my.refuse")
        def refuse():
            return False

        @interpreter.action("my.number")
        def number(value: float):
            self.fail("it is no number")

        interpreter.add_agent(
            "ann",
            """!a. !b. +!a <- my.refuse. +!b <- my.number("x").
            -!a[error(E)] <- .print(a, " ", E). -!b[error(E), error_msg(M)] <- .print(b, " ", M).""",
        )
        interpreter.run()
        self.assertEqual(self.lines[0], "[ann] a ia_failed")
        self.assertIn("a number", self.lines[1])

    def test_shows_the_traceback_of_an_exception_once_and_fails_the_action(self):
        interpreter = self.interpreter()

        @interpreter.action("my.divide")
        def divide(value):
            return 1 / value

        interpreter.add_agent("ann", "!d. !d. +!d <- my.divide(0). -!d[error(E)] <- .print(E).")
        shown = io.StringIO()
        with contextlib.redirect_stderr(shown):
            interpreter.run()
        self.assertEqual(self.lines, ["[ann] python_error"] * 2)
        self.assertEqual(shown.getvalue().count("ZeroDivisionError"), 1)
        self.assertIn("return 1 / value", shown.getvalue())

    def test_passes_keyboard_interrupts_on_to_the_caller(self):
        interpreter = self.interpreter()

        @interpreter.action("my.stop")
        def stop():
            raise KeyboardInterrupt

        interpreter.add_agent("ann", "!s. +!s <- my.stop; !s. -!s <- !s.")
        with self.assertRaises(KeyboardInterrupt):
            interpreter.run()

    def test_points_at_the_mistakes_of_a_program(self):
        with self.assertRaises(jaywalk.Error) as caught:
            self.interpreter().add_agent("ann", "!go.\n+!go <- .print(1.")
        (mistake,) = caught.exception.diagnostics
        self.assertEqual((mistake.severity, mistake.file, mistake.line), ("error", "ann", 2))
        self.assertIn("^", str(caught.exception))

    def test_checks_programs(self):
        self.assertEqual(jaywalk.check("!go. +!go <- .print(1)."), [])
        (slip,) = jaywalk.check("!go. +!go <- .pritn(1).")
        self.assertEqual((slip.line, slip.column), (1, 14))
        self.assertIn("did you mean", slip.hint)

    def test_refuses_names_and_programs_that_do_not_fit(self):
        interpreter = self.interpreter()
        with self.assertRaisesRegex(ValueError, "has a dot"):
            interpreter.action("note")
        with self.assertRaisesRegex(TypeError, "derived from Environment"):
            jaywalk.Interpreter(environment=object())
        agent = interpreter.add_agent("ann")
        with self.assertRaisesRegex(ValueError, "before the first program"):
            interpreter.action("my.note")
        with self.assertRaises(jaywalk.Error):
            agent.believe("1 +")
        with self.assertRaises(TypeError):
            agent.believe(Structure("p", (object(),)))
        for unwritable in (float("nan"), "back\\slash"):
            with self.assertRaises(ValueError):
                agent.believe(Structure("p", (unwritable,)))

    def test_refuses_terms_that_are_nested_without_end(self):
        interpreter = self.interpreter()

        @interpreter.function("my.cyclic")
        def cyclic():
            endless = []
            endless.append(endless)
            return endless

        agent = interpreter.add_agent(
            "ann", "!a. +!a <- my.cyclic(X). -!a[error(E)] <- .print(E). !deep(100000, x). +!deep(0, T) <- +t(T). "
                   "+!deep(N, T) <- !deep(N-1, f(T))."
        )
        with contextlib.redirect_stderr(io.StringIO()):
            interpreter.run()
        self.assertIn("[ann] python_error", self.lines)
        for look in (lambda: agent.ask("t(T)"), lambda: agent.beliefs):
            with self.assertRaises(RecursionError):
                look()
        self.assertTrue(agent.holds("t(f(_))"))

    def test_runs_interpreters_in_threads_and_one_in_one_thread_at_a_time(self):
        outcomes = []

        def run():
            interpreter = self.interpreter()
            interpreter.add_agent("ann", "!c(20000). +!c(0). +!c(N) <- !c(N-1).")
            outcomes.append(interpreter.run().cycles)

        def parse():
            for number in range(500):
                outcomes.append(str(jaywalk.literal(f"p({number})")) == f"p({number})")

        threads = [threading.Thread(target=each) for each in (run, run, run, parse, parse)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(len(outcomes), 3 + 2 * 500)
        self.assertEqual(len(set(outcomes)), 2)  # True, and one number of cycles
        self.assertEqual(outcomes.count(True), 2 * 500)

        interpreter = self.interpreter()
        refused = []

        @interpreter.action("my.other")
        def other():
            def use():
                try:
                    interpreter.step()
                except RuntimeError as error:
                    refused.append(str(error))

            thread = threading.Thread(target=use)
            thread.start()
            thread.join()

        interpreter.add_agent("ann", "!s. +!s <- my.other.")
        interpreter.run()
        self.assertEqual(refused, ["another thread is using this interpreter"])


class Room(jaywalk.Environment):
    tick_ms = 60_000

    def __init__(self):
        self.degrees = 20
        self.minutes = 0

    def percepts(self, agent):
        return None if self.minutes == 3 else [f"temperature({self.degrees})", Structure("owner", (Atom(agent),))]

    def act(self, agent, action):
        if action.functor != "heat":
            raise ValueError(f"no such switch: {action}")
        self.degrees += action[0]

    def advance(self):
        self.degrees -= 1
        self.minutes += 1

    def finished(self):
        return self.minutes == 6


class EnvironmentTest(unittest.TestCase):
    def test_is_perceived_and_acted_on(self):
        lines = []
        room = Room()
        interpreter = jaywalk.Interpreter(environment=room, print=lines.append)
        agent = interpreter.add_agent("ann", "+temperature(T) : T < 19 <- .print(T); heat(3). +owner(O) <- .print(O).")
        outcome = interpreter.run()
        self.assertEqual(lines, ["[ann] ann", "[ann] 18", "[ann] 18"])
        self.assertEqual((outcome.end, outcome.ticks, interpreter.now_ms), ("finished", 6, 360_000))
        self.assertIn(Structure("owner", (Atom("ann"),), (Structure("source", (Atom("percept"),)),)), agent.beliefs)

    def test_says_why_an_action_failed(self):
        lines = []
        interpreter = jaywalk.Interpreter(environment=Room(), print=lines.append)
        interpreter.add_agent("ann", "!a. +!a <- cool(1). -!a[error(E), error_msg(M)] <- .print(E, ': ', M).")
        with contextlib.redirect_stderr(io.StringIO()):
            interpreter.run()
        self.assertIn("action_failed", lines[0])
        self.assertIn("ValueError: no such switch: cool(1)", lines[0])

    def test_needs_a_tick_that_takes_time(self):
        class Timeless(Room):
            tick_ms = 0

        with self.assertRaisesRegex(ValueError, "tick_ms: expected"):
            jaywalk.Interpreter(environment=Timeless())

    def test_ends_the_run_with_the_exception_of_its_clock(self):
        class Broken(Room):
            def advance(self):
                raise RuntimeError("no time")

        interpreter = jaywalk.Interpreter(environment=Broken())
        interpreter.add_agent("ann")
        with self.assertRaisesRegex(RuntimeError, "no time"):
            interpreter.run()

    def test_ends_the_run_with_the_exception_of_its_percepts(self):
        class Broken(Room):
            def percepts(self, agent):
                return [Structure("name", ([1, None],))]

        interpreter = jaywalk.Interpreter(environment=Broken())
        interpreter.add_agent("ann")
        with self.assertRaisesRegex(TypeError, "a percept has no variables"):
            interpreter.run()

    def test_evaluates_functions_in_arithmetic(self):
        lines = []
        interpreter = jaywalk.Interpreter(print=lines.append)

        @interpreter.arithmetic("road.kmh")
        def kmh(speed: float):
            return speed * 3.6

        @interpreter.arithmetic("road.broken")
        def broken(of):
            return "fast" if of else 1 / of

        interpreter.add_agent(
            "ann",
            "!a. !b(0). !b(1). +!a <- X = road.kmh(10) + 1; .print(X). +!b(N) <- .print(road.broken(N) + 1).",
        )
        shown = io.StringIO()
        with contextlib.redirect_stderr(shown):
            interpreter.run()
        self.assertEqual(sorted(lines), ["[ann] (road.broken(0)+1)", "[ann] (road.broken(1)+1)", "[ann] 37"])
        self.assertIn("ZeroDivisionError", shown.getvalue())
        self.assertIn("expected a number as its result", shown.getvalue())

    def test_perceives_any_terms(self):
        class Shelf(jaywalk.Environment):
            def percepts(self, agent):
                return ['book("Ulysses", [1922, pages(732)])[seen_by(eye)]', Structure("~open", (Structure("lid", (1,)),))]

        lines = []
        interpreter = jaywalk.Interpreter(environment=Shelf(), print=lines.append)
        interpreter.add_agent(
            "ann",
            "+book(T, [Y, P])[seen_by(S)] <- .print(T, Y, P, S)." "+~open(L) <- .print(L).",
        )
        for _ in range(3):
            interpreter.step()
        self.assertEqual(lines, ["[ann] Ulysses1922pages(732)eye", "[ann] lid(1)"])

    def test_lets_actions_take_longer(self):
        class Oven(jaywalk.Environment):
            tick = 0

            def __init__(self):
                self.baking = {}

            def act(self, agent, action):
                return self.baking.setdefault(str(action), jaywalk.Pending())

            def advance(self):
                self.tick += 1
                if self.tick == 3:
                    self.baking["bake(bread)"].succeed()
                if self.tick == 2:
                    self.baking["bake(cake)"].fail("too hot")
                    self.baking["bake(cake)"].succeed()

        lines = []
        interpreter = jaywalk.Interpreter(environment=Oven(), print=lines.append)
        interpreter.add_agent(
            "ann",
            "!b. !c. +!b <- bake(bread); .print(bread). +!c <- bake(cake)." "-!c[error_msg(M)] <- .print(M).",
        )
        printed = []
        for _ in range(6):
            interpreter.step()
            printed.append(len(lines))
        self.assertEqual(lines, ["[ann] too hot", "[ann] bread"])
        self.assertEqual(printed, [0, 0, 1, 2, 2, 2])

    def test_keeps_beliefs_while_percepts_are_none(self):
        class Lamp(jaywalk.Environment):
            looks = 0

            def percepts(self, agent):
                self.looks += 1
                return ["lit"] if self.looks in (1, 5) else None

        lines = []
        world = Lamp()
        interpreter = jaywalk.Interpreter(environment=world, print=lines.append)
        interpreter.add_agent("ann", "+lit <- .print(lit); -lit[source(percept)].")
        for _ in range(6):
            interpreter.step()
        self.assertEqual((lines, world.looks), (["[ann] lit", "[ann] lit"], 6))


if __name__ == "__main__":
    unittest.main()
