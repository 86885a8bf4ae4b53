# SPDX-License-Identifier: Apache-2.0
"""Search-based testing: looks for inputs of a function, or of a search's file, that fail."""
from __future__ import annotations

import json
import math
import os
from typing import Any, Callable, Iterable, Mapping, Optional, Sequence, Union

from jaywalk import _native
from jaywalk.bench import Path, _dataframe, data_folder, shipped
from jaywalk.terms import whole, whole_or_none

#: From and to; or of a signal {"range": (0, 100), "pieces": 6}, as the key `inputs` of a search's file has it.
Range = Union[tuple[float, float], Mapping[str, Any]]
Space = Union[Mapping[str, Range], Sequence[Range]]


class Generator:
    """A generator of your own: derive from it, and give the class to `search`, which makes an object for each search.

    Inputs are lists of numbers from -1 to 1, however the space is given.
    """

    def __init__(self, dimension: int, seed: int):
        self.dimension = dimension
        self.seed = seed

    def ask(self, is_valid: Callable[[Sequence[float]], bool], spent: float) -> Sequence[float]:
        """The next input, which must be valid; `spent` is the share of the budget that is spent, from 0 to 1."""
        raise NotImplementedError

    def tell(self, input: Sequence[float], fitness: float, failed: bool) -> None:
        """The result of the latest input: its fitness from 0 (harmless) to 1 (worst), and whether it failed."""


class SearchResult:
    """The tests of all searches, in their order."""

    def __init__(self, said: dict):
        #: One dict a test: generator, repetition, test (from 0), input, fitness (0 to 1), failed, error, refused (why a
        #: program takes the input for none that may be tested), the measures.
        self.rows: list[dict[str, Any]] = said["rows"]
        #: False if the search was ended before its budget was spent.
        self.is_complete: bool = said["is_complete"]

    @property
    def failures(self) -> list[dict[str, Any]]:
        """The tests that failed."""
        return [row for row in self.rows if row["failed"]]

    @property
    def tests_to_first_failure(self) -> dict[tuple[str, int], Optional[int]]:
        """By (generator, repetition); None: no test failed."""
        first: dict[tuple[str, int], Optional[int]] = {}
        for row in self.rows:
            key = (row["generator"], row["repetition"])
            first.setdefault(key, None)
            if row["failed"] and first[key] is None:
                first[key] = row["test"] + 1
        return first

    def to_dataframe(self):
        """The rows as a pandas.DataFrame."""
        return _dataframe(self.rows)

    def __repr__(self) -> str:
        return f"<search of {len(self.rows)} tests, {len(self.failures)} failed>"


def search(
    fitness: Union[Callable[..., float], Path],
    space: Optional[Space] = None,
    *,
    generator: Union[None, str, type[Generator], Iterable[Union[str, type[Generator]]]] = None,
    budget: Optional[int] = None,
    harmless: float = 0,
    worst: float = 1,
    fails_at: float = 0.95,
    why_invalid: Optional[Callable[..., Optional[str]]] = None,
    seed: Optional[int] = None,
    repetitions: Optional[int] = None,
    threads: int = 1,
    params: Optional[Mapping[str, Any]] = None,
    store: Optional[Path] = None,
    resume: bool = False,
    progress: Optional[Callable[[int, int], None]] = None,
) -> SearchResult:
    """Looks for inputs that fail.

    Of a function: `space` has the range of each input, by name ({"speed": (0, 30)}: the function is called with
    keywords) or in order ([(0, 30), (-1, 1)]: with one list). {"range": (0, 100), "pieces": 6} in the place of a range
    is a signal, of which the function gets the list of the pieces' values. It returns a number: fitness is 0 at `harmless` and
    beyond, 1 at `worst` and beyond, and a test fails from `fails_at` on. (A robustness, which fails below 0: harmless=10,
    worst=0, fails_at=1.) `budget` is the number of tests of each search. `why_invalid` is called as the function is,
    and returns why such an input cannot be tested, or None. An exception of the function makes its test errored, and is
    shown with its traceback once.

    Of a file (the path of a YAML file, the name of one that comes with Jaywalk, or its text): its system and budget
    count, `params` replace values, and a `store` keeps all tests.

    `generator` is a name of `generators()`, a class derived from Generator, or several of them; by default "prospect",
    or those of the file. A search is a function of the `seed`, whatever the number of `threads`.
    """
    seed = whole_or_none("seed", seed)
    repetitions = whole_or_none("repetitions", repetitions, 1, 2**31 - 1)
    threads = whole("threads", threads, 1, _native.MOST_THREADS)
    budget = whole_or_none("budget", budget, 1)
    if not callable(fitness):
        given = [] if generator is None else [generator] if isinstance(generator, str) else list(generator)
        name, text = os.fspath(fitness), None
        if "\n" in name:
            name, text = "text.yaml", name
        else:
            name = shipped(name, "scenarios/search")
        sets = [f"{key}={json.dumps(value)}" for key, value in (params or {}).items()]
        sets += [] if budget is None else [f"budget.tests={budget}"]
        return SearchResult(
            _native.search_file(name, text, sets, given, data_folder(), seed, repetitions, threads, os.fspath(store or ""), resume, progress)
        )
    if store is not None or params is not None:
        raise ValueError("a store and params are for searches that are files")
    if space is None or budget is None:
        raise TypeError("a search of a function needs a space and a budget")
    names, ranges = _read_space(space)

    def scaled(values: Sequence[float]) -> list[Any]:
        rest = iter(values)
        inputs: list[Any] = []
        for low, high, pieces in ranges:
            own = [low + (next(rest) + 1) / 2 * (high - low) for _ in range(pieces or 1)]
            inputs.append(own if pieces else own[0])
        return inputs

    def called(function: Callable) -> Callable:
        if names is None:
            return lambda values: function(scaled(values))
        return lambda values: function(**dict(zip(names, scaled(values))))

    chosen = ["prospect"] if generator is None else [generator] if isinstance(generator, (str, type)) else list(generator)
    said = _native.search_function(
        called(fitness),
        None if why_invalid is None else called(why_invalid),
        sum(pieces or 1 for _, _, pieces in ranges),
        harmless,
        worst,
        fails_at,
        [each if isinstance(each, str) else (each.__name__, each) for each in chosen],
        budget,
        0 if seed is None else seed,
        1 if repetitions is None else repetitions,
        threads,
        progress,
    )
    for row in said["rows"]:
        values = scaled(row["input"])
        row["input"] = values if names is None else dict(zip(names, values))
        del row["points"], row["simulated_s"]
    return SearchResult(said)


def generators() -> dict[str, str]:
    """The generators that come with Jaywalk, and what each does."""
    return _native.generators()


def _read_space(space: Space) -> tuple[Optional[list[str]], list[tuple[float, float, Optional[int]]]]:
    """The names, if there are any, and from, to and the number of pieces (None: one value) of each input."""
    names = list(space) if isinstance(space, Mapping) else None
    ranges = []
    for index, each in enumerate(space.values() if isinstance(space, Mapping) else space):
        name = names[index] if names else index
        pieces = None
        if isinstance(each, Mapping):
            if set(each) != {"range", "pieces"}:
                raise ValueError(f"a signal has a range and pieces; {name} has {', '.join(map(str, each)) or 'nothing'}")
            pieces = whole(f"pieces of {name}", each["pieces"], 1, 1000)
            each = each["range"]
        low, high = each
        if not (math.isfinite(low) and math.isfinite(high)):
            raise ValueError(f"the range of {name} is not finite: {low} to {high}")
        if not low < high:
            raise ValueError(f"the range of {name} is empty: {low} to {high}")
        ranges.append((low, high, pieces))
    return names, ranges
