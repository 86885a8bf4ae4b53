# SPDX-License-Identifier: Apache-2.0
"""BDI agents: an interpreter of AgentSpeak, internal actions as Python functions, worlds as Python classes."""
from __future__ import annotations

import builtins
import inspect
import os
import sys
import typing
from dataclasses import dataclass
from typing import Any, Callable, Iterable, Optional, Union

from jaywalk import _native
from jaywalk.terms import Atom, Diagnostic, Structure, WrongArgument, as_literal, text_of, whole

Literal = Union[str, Atom, Structure]


@dataclass(frozen=True)
class RunOutcome:
    """How a run ended.

    `end` is "idle" (nothing is left to do), "stopped" (by `.stopMAS`), "finished" (the environment says so), "limit"
    or "looping" (`message` says which limit, or which agent never rests), "interrupted" (an exception has ended it).
    """

    end: str
    ticks: int
    cycles: int
    inferences: int
    exit_code: int
    message: str


class Pending:
    """The result of an action that takes longer than a tick. Until it is known the action's intention waits, while
    others of the agent go on; the agent hears of it at the beginning of the next tick. Any thread may set it."""

    def __init__(self) -> None:
        self._result: Optional[tuple[bool, str]] = None

    def succeed(self) -> None:
        """The action is done. What is set first counts."""
        self._result = self._result or (True, "")

    def fail(self, reason: str = "") -> None:
        """The action has failed; the reason is the failure's `error_msg`."""
        self._result = self._result or (False, reason)


class Environment:
    """A world of your own: derive from it, and give an object of it to Interpreter.

    In each tick every agent perceives, reasons until it has chosen an action or is idle, then all actions take effect
    and the world advances.
    """

    #: The length of a tick in milliseconds of the agents' time.
    tick_ms: float = 1000

    def percepts(self, agent: str) -> Optional[Iterable[Literal]]:
        """All that the agent perceives now, as texts ("at(2,5)"), Atoms or Structures without variables. None: its
        beliefs stay as they are."""
        return ()

    def act(self, agent: str, action: Structure) -> Union[bool, Pending, None]:
        """Does what the agent has chosen. False, or an exception: the action fails, and with it the plan. A Pending:
        the action takes longer than this tick."""
        return False

    def advance(self) -> None:
        """Everything that is not an agent moves on by one tick."""

    def finished(self) -> bool:
        """Whether the run ends."""
        return False


class Agent:
    """An agent of an interpreter. Beliefs and goals are given as texts, Atoms or Structures."""

    def __init__(self, interpreter: Interpreter, number: int):
        self._native = interpreter._native
        self._number = number
        #: The name that it got.
        self.name: str = self._native.agent_name(number)

    def __repr__(self) -> str:
        return f"<agent {self.name}>"

    @property
    def is_alive(self) -> bool:
        """False once it has ended."""
        return self._native.is_alive(self._number)

    def believe(self, belief: Literal, source: Optional[str] = None) -> None:
        """Adds a belief, as its own formula `+b` would. `source` names whoever says so; else it is the agent itself."""
        self._native.believe(self._number, _with_source(belief, source))

    def forget(self, belief: Literal, source: Optional[str] = None) -> None:
        """Removes the first belief that unifies; None and `_` stand for anything."""
        self._native.forget(self._number, _with_source(belief, source))

    def achieve(self, goal: Literal, source: Optional[str] = None) -> None:
        """Gives it the goal."""
        self._native.achieve(self._number, _with_source(goal, source))

    def include(self, text: str, name: str = "text") -> None:
        """Gives it all beliefs, rules, goals and plans of a program's text."""
        self._native.include(self._number, name, text)

    def ask(self, query: Literal, most: int = 0) -> list[dict[str, Any]]:
        """The answers to a formula of a plan's context ("age(X,N) & N > 18"): the values of its variables, by their
        names. At most `most` of them; 0: all."""
        return self._native.ask(self._number, text_of_literal(query), whole("most", most))

    def holds(self, query: Literal) -> bool:
        """Whether the formula has an answer."""
        return bool(self.ask(query, 1))

    @property
    def beliefs(self) -> list[Structure]:
        """Its beliefs, in the order of the belief base."""
        return [as_literal(each) for each in self._native.beliefs(self._number)]

    @property
    def intentions(self) -> list[str]:
        """The goals of each intention, the outermost first: "test_av > cross > step(right)"."""
        return self._native.intentions(self._number)


class Interpreter:
    """Runs agents. One thread uses it at a time; several interpreters share nothing, and may run in threads.

    `print` receives each line that agents print, `log` each warning of the run; None: they are dropped. A run is a
    function of the programs, the environment and the `seed`. `max_cycles` bounds the reasoning cycles of each agent
    (0: no bound); `realtime` lets timers and ticks follow the clock on the wall.
    """

    def __init__(
        self,
        *,
        environment: Optional[Environment] = None,
        seed: int = 0,
        print: Optional[Callable[[str], None]] = builtins.print,
        log: Optional[Callable[[str], None]] = lambda line: builtins.print(line, file=sys.stderr),
        max_cycles: int = 0,
        realtime: bool = False,
    ):
        if environment is not None and not isinstance(environment, Environment):
            raise TypeError(f"the environment is an object of a class derived from Environment, found {environment!r}")
        self._native = _native.Interpreter(
            whole("seed", seed), print, log, environment, whole("max_cycles", max_cycles), realtime
        )
        self._programs = 0

    def action(self, name: str) -> Callable[[Callable], Callable]:
        """A decorator: the function becomes an internal action, with as many arguments as it has parameters.

        It succeeds unless the function returns False. An exception fails it (`error(python_error)`), and is shown with
        its traceback once. Parameters annotated int, float, str, list, Atom or Structure accept nothing else.
        """
        return self._decorator(name, lambda *added: self._native.add_action(*added, False))

    def function(self, name: str) -> Callable[[Callable], Callable]:
        """A decorator: as `action`, and what the function returns is unified with one more argument, the last.

        What a generator yields are several answers, which a plan's context or a rule tries in turn.
        """
        return self._decorator(name, lambda name, parameters, body: self._native.add_action(name, parameters + 1, body, True))

    def arithmetic(self, name: str) -> Callable[[Callable], Callable]:
        """A decorator: the function stands in arithmetic expressions, `X = road.kmh(Speed) + 1`.

        It returns a number that depends on its arguments alone. After an exception, which is shown with its traceback
        once, it has no value, and the expression stays as it is.
        """
        return self._decorator(name, self._native.add_arithmetic)

    def _decorator(self, name: str, add_native: Callable[[str, int, Callable], None]) -> Callable[[Callable], Callable]:
        if "." not in name:
            raise ValueError(f"the name of an internal action has a dot, as in 'my.{name}'")
        if self._programs:
            raise ValueError(f"'{name}' has to be added before the first program is loaded")

        def add(body: Callable) -> Callable:
            parameters = list(inspect.signature(body).parameters.values())
            wrong = [each for each in parameters if each.kind not in (each.POSITIONAL_ONLY, each.POSITIONAL_OR_KEYWORD)]
            if wrong:
                raise TypeError(f"an internal action has positional parameters alone, found '{wrong[0]}'")
            add_native(name, len(parameters), _checked(body, parameters))
            return body

        return add

    def add_agent(self, name: str, program: Union[str, os.PathLike] = "", include: Iterable[str] = ()) -> Agent:
        """An agent that runs a program: the path of a file (`.asl`), or a text of AgentSpeak.

        `include` are folders in which included files are searched. A name that is taken gets a suffix. Errors:
        jaywalk.Error with the places of the program's mistakes.
        """
        text = None if is_path(program) else str(program)
        self._programs += 1
        loaded = self._native.load(name if text is not None else os.fspath(program), text, [os.fspath(each) for each in include])
        return Agent(self, self._native.add_agent(name, loaded))

    def run(self) -> RunOutcome:
        """Runs until all agents are idle, one of them stops the run, the environment is finished or a limit is
        reached. It may be called again when there is more to do."""
        return RunOutcome(**self._native.run())

    def step(self) -> bool:
        """One tick; without an environment one reasoning cycle of each agent that has something to do. False: the run
        has ended."""
        return self._native.step()

    @property
    def now_ms(self) -> float:
        """The agents' time since the run began, in milliseconds."""
        return self._native.now_ms()


def check(program: Union[str, os.PathLike], include: Iterable[str] = ()) -> list[Diagnostic]:
    """The mistakes of a program, the path of a file (`.asl`) or a text: those that `jaywalk check` finds."""
    name = "text"
    text = str(program)
    if is_path(program):
        name = os.fspath(program)
        with open(name, encoding="utf-8") as file:
            text = file.read()
    return _native.check_program(name, text, [os.fspath(each) for each in include])


def is_path(program: Any) -> bool:
    """Whether it is the path of a program, rather than its text."""
    return isinstance(program, os.PathLike) or (program.endswith(".asl") and "\n" not in program)


def text_of_literal(literal: Literal) -> str:
    return literal if isinstance(literal, str) else text_of(literal)


def _with_source(literal: Literal, source: Optional[str]) -> str:
    if source is None:
        return text_of_literal(literal)
    told = as_literal(literal)
    return str(Structure(told.functor, told.args, (*told.annotations, Structure("source", (Atom(source),)))))


_EXPECTED = {
    int: (int, "a whole number"),
    float: ((int, float), "a number"),
    str: (str, "a string"),
    list: (list, "a list"),
    Atom: (Atom, "an atom"),
    Structure: ((Structure, Atom), "a literal"),
}


def _checked(body: Callable, parameters: list[inspect.Parameter]) -> Callable:
    """The function behind a check of its arguments by their annotations."""
    try:
        hints = typing.get_type_hints(body)
    except Exception:  # names that exist for type checkers alone
        hints = {}
    wanted = [(index, *_EXPECTED[hints[each.name]]) for index, each in enumerate(parameters) if hints.get(each.name) in _EXPECTED]
    if not wanted:
        return body

    def checked(*args: Any) -> Any:
        for index, types, expected in wanted:
            if not isinstance(args[index], types):
                raise WrongArgument(index, expected)
        return body(*args)

    return checked
