# SPDX-License-Identifier: Apache-2.0
"""Terms of AgentSpeak as Python values, and what errors look like.

A number is an int or a float, a string a str, a list a list; an atom is an Atom, a structure a Structure. A variable
without a value is None.
"""
from __future__ import annotations

import functools
import math
import sys
import threading
import traceback
from dataclasses import dataclass, field
from typing import Any, Optional


@dataclass(frozen=True)
class Atom:
    """An atom, such as `left`. It differs from the string "left", as in AgentSpeak."""

    name: str

    def __str__(self) -> str:
        return self.name

    def __repr__(self) -> str:
        return f"Atom({self.name!r})"


class Structure:
    """A literal with arguments or annotations: `Structure("at", (2, 5))` is `at(2,5)`, "~at" its strong negation.

    Equal structures have equal functors, arguments and annotations; a structure is iterated over its arguments.
    """

    __slots__ = ("functor", "args", "annotations")

    def __init__(self, functor: str, args: Any = (), annotations: Any = ()):
        if not isinstance(args, (tuple, list)):
            raise TypeError(f"the arguments of a structure are a tuple or list, found {args!r}")
        self.functor = functor
        self.args = tuple(args)
        self.annotations = tuple(annotations)

    @property
    def source(self) -> Optional[Any]:
        """The first source among the annotations: Atom("self"), Atom("percept") or an agent's name."""
        for each in self.annotations:
            if isinstance(each, Structure) and each.functor == "source" and len(each.args) == 1:
                return each.args[0]
        return None

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Structure):
            return NotImplemented
        return (self.functor, self.args, self.annotations) == (other.functor, other.args, other.annotations)

    def __hash__(self) -> int:
        return hash((self.functor, str(self)))

    def __iter__(self):
        return iter(self.args)

    def __len__(self) -> int:
        return len(self.args)

    def __getitem__(self, index):
        return self.args[index]

    def __str__(self) -> str:
        text = self.functor
        if self.args:
            text += "(" + ",".join(map(text_of, self.args)) + ")"
        if self.annotations:
            text += "[" + ",".join(map(text_of, self.annotations)) + "]"
        return text

    def __repr__(self) -> str:
        return f"<{self}>"


_ESCAPES = str.maketrans({'"': '\\"', "\n": "\\n"})


def text_of(value: Any) -> str:
    """The value as AgentSpeak writes it. Errors: TypeError or ValueError if it has no such text."""
    if value is None:
        return "_"
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, str):
        if "\\" in value:
            raise ValueError(f"AgentSpeak has no text for a string with a backslash, found {value!r}")
        return '"' + value.translate(_ESCAPES) + '"'
    if isinstance(value, (Atom, Structure)):
        return str(value)
    if isinstance(value, (list, tuple)):
        return "[" + ",".join(map(text_of, value)) + "]"
    try:
        number = float(value)
    except (TypeError, ValueError):
        raise TypeError(f"expected a number, str, Atom, Structure, list or None, found {value!r}") from None
    if not math.isfinite(number):
        raise ValueError(f"AgentSpeak cannot write the number {number}")
    return str(int(number)) if number.is_integer() and abs(number) <= 2**53 else repr(number)


@functools.lru_cache(maxsize=4096)
def literal(text: str) -> Structure:
    """The literal that a text stands for: `literal("at(2,5)[source(ann)]")`. Errors: jaywalk.Error with its place."""
    value = _parser().ask(0, f"Parsed = ({text})", 1)
    found = value[0].get("Parsed") if value else None
    if not isinstance(found, (Atom, Structure)):
        raise ValueError(f"expected a literal such as at(2,5), found {text!r}")
    return as_literal(found)


_of_thread = threading.local()


def _parser():
    """An interpreter with one agent, each thread its own: one thread at a time may use an interpreter."""
    if not hasattr(_of_thread, "parser"):
        from jaywalk import _native

        _of_thread.parser = _native.Interpreter(0, None, None, None, 0, False)
        _of_thread.parser.add_agent("parser", _of_thread.parser.load("parser", "", []))
    return _of_thread.parser


def as_literal(value: Any) -> Structure:
    """An Atom, Structure or text as a Structure."""
    if isinstance(value, Structure):
        return value
    if isinstance(value, Atom):
        return Structure(value.name)
    if isinstance(value, str):
        return literal(value)
    raise TypeError(f"expected a literal (an Atom, Structure or text), found {value!r}")


@dataclass(frozen=True)
class Diagnostic:
    """An error or warning about a program, scenario or option; `str` shows its line with a caret.

    `severity` is "error", "warning" or "note"; `line` and `column` count from 1 and are None where there is no text;
    `code` is the name by which a warning is silenced.
    """

    severity: str
    message: str
    file: str
    line: Optional[int]
    column: Optional[int]
    hint: str = ""
    code: str = ""
    rendered: str = field(default="", repr=False, compare=False)

    def __str__(self) -> str:
        return self.rendered.rstrip("\n")


class Error(Exception):
    """What was given cannot be used; `diagnostics` says where and why, `str` shows it."""

    def __init__(self, diagnostics: list[Diagnostic]):
        super().__init__(diagnostics)
        self.diagnostics = diagnostics

    def __str__(self) -> str:
        return "\n".join(map(str, self.diagnostics))


class WrongArgument(TypeError):
    """Raised by an internal action: the argument `index`, from 0, is not what was `expected` ("a speed in m/s")."""

    def __init__(self, index: int, expected: str):
        super().__init__(f"argument {index + 1}: expected {expected}")
        self.index = index
        self.expected = expected


def whole(name: str, value: Any, least: int = 0, most: int = 2**63 - 1) -> int:
    """A whole number from `least` to `most`; else ValueError names it."""
    if isinstance(value, bool) or not hasattr(value, "__index__") or not least <= value.__index__() <= most:
        raise ValueError(f"{name}: expected a whole number from {least} to {most}, found {value!r}")
    return value.__index__()


def whole_or_none(name: str, value: Any, least: int = 0, most: int = 2**63 - 1) -> Optional[int]:
    return None if value is None else whole(name, value, least, most)


_reported: set[tuple] = set()


def report_exception(where: str, error: Any) -> str:
    """Shows an exception with its traceback, each kind at each place once; returns it in one line."""
    if isinstance(error, str):
        text, place = error, ()
    else:
        text = "".join(traceback.format_exception_only(type(error), error)).strip()
        frames = traceback.extract_tb(error.__traceback__)
        place = (frames[-1].filename, frames[-1].lineno) if frames else ()
    if (where, type(error), place) not in _reported:
        _reported.add((where, type(error), place))
        print(f"jaywalk: {where} has failed (shown once):", file=sys.stderr)
        if isinstance(error, str):
            print(text, file=sys.stderr)
        else:
            traceback.print_exception(type(error), error, error.__traceback__)
    return f"{where}: {text}"
