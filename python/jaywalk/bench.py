# SPDX-License-Identifier: Apache-2.0
"""The test bench: scenarios, tests, comparisons of behaviours, results stores, judging of recorded drives."""
from __future__ import annotations

import contextlib
import html
import json
import os
import pathlib
import re
import sqlite3
import tempfile
from dataclasses import dataclass
from typing import Any, Callable, Iterable, Mapping, Optional, Union

from jaywalk import _native
from jaywalk.agents import is_path
from jaywalk.terms import Diagnostic, Structure, whole, whole_or_none

Path = Union[str, os.PathLike]


def data_folder() -> str:
    """The folder of the agents and scenarios that come with Jaywalk."""
    package = pathlib.Path(__file__).parent
    for folder in (package / "data", package.parents[3] / "share" / "jaywalk"):
        if (folder / "scenarios").is_dir():
            return str(folder.resolve())
    return ""


def shipped(path: Path, folder: str) -> str:
    """The path if there is such a file, else that of the file of this name that comes with Jaywalk."""
    given = os.fspath(path)
    if os.path.exists(given):
        return given
    for found in (pathlib.Path(data_folder(), given), pathlib.Path(data_folder(), folder, given + ".yaml")):
        if found.is_file():
            return str(found)
    return given


class AV:
    """An automated vehicle of your own: derive from it, and give the class to `load_scenario` or `compare`.

    An object is made for each test. What it decides must depend on the views of its test alone. An exception ends the
    test errored, and is shown with its traceback once.
    """

    def act(self, view: Any) -> float:
        """An acceleration in m/s², negative to brake; what a vehicle can do limits it to -9.80665 to 5.

        `view` has what the sensors see: time_s, period_s, speed_mps, cruise_mps, left_m, right_m, lane_left_m,
        lane_right_m, front_m, length_m, range_m, and the lists actors, stop_lines, obstacles and lanes. An actor has
        id, kind, gap_m (from the front of the AV; negative beside and behind it), left_m, right_m, speed_ahead_mps,
        speed_right_mps, length_m and heading_rad. docs/reference/controller_protocol.md says what each is.
        """
        raise NotImplementedError


@dataclass(frozen=True)
class Verdict:
    """An assertion's verdict on a test: "pass", "fail", "vacuous" (its precondition was not met) or "unavoidable".

    `robustness` says by how much the requirement was kept, in its own unit; `tick` is the first that violates it.
    """

    verdict: str
    robustness: Optional[float]
    tick: Optional[int]


@dataclass(frozen=True)
class Event:
    """Something that happened: to the actor of that name, or to the whole test if that is empty."""

    tick: int
    actor: str
    kind: str
    text: str


class Test:
    """A test that was run. A notebook shows it as a page that plays it."""

    __test__ = False  # pytest, it is none of yours

    def __init__(self, said: dict, page: Optional[Callable[[], str]]):
        #: Why it came to no end of its own; empty: it did. Nothing else counts of an errored test.
        self.error: str = said["error"]
        #: The precondition of the assertion under test was met.
        self.succeeded: bool = said["succeeded"]
        #: The word for why it ended: "precondition", "collision", "road_end", "time_limit", …
        self.ended_by: str = said["ended_by"]
        self.ticks: int = said["ticks"]
        #: The length of a tick in seconds.
        self.tick_s: float = said["tick_s"]
        #: Rewards less costs, the mean over all agents.
        self.score: float = said["score"]
        #: The speed of the first collision in m/s, if there was one.
        self.impact_mps: Optional[float] = said["impact_mps"]
        #: By the names of the assertions.
        self.verdicts: dict[str, Verdict] = {name: Verdict(*rest) for name, *rest in said["verdicts"]}
        #: In the order of time.
        self.events: list[Event] = [Event(*each) for each in said["events"]]
        #: By name, in the units of docs/reference/measures.md; None: it does not exist in this test.
        self.metrics: dict[str, Optional[float]] = said["metrics"]
        #: Remarks about what was read.
        self.warnings: list[Diagnostic] = said.get("warnings", [])
        self._actors = said["actors"]
        self._page = page

    def __repr__(self) -> str:
        return f"<test, {self.error and 'errored' or self.ended_by} after {self.ticks} ticks>"

    @property
    def actors(self) -> list[str]:
        """Their names, the AV first."""
        return [each["name"] for each in self._actors]

    @property
    def trajectory(self) -> dict[str, list]:
        """Columns with a row for each actor at each tick: tick, time_s, actor, kind, length_m, width_m, x_m, y_m (the
        middle of its box; y along the way of the AV, x to its right), speed_mps, heading_rad. `judge` takes them."""
        ticks = range(len(self._actors[0]["x_m"]))
        columns: dict[str, list] = {
            "tick": [tick for tick in ticks for _ in self._actors],
            "time_s": [tick * self.tick_s for tick in ticks for _ in self._actors],
            "actor": [actor["name"] for _ in ticks for actor in self._actors],
        }
        for name in ("kind", "length_m", "width_m"):
            columns[name] = [actor[name] for _ in ticks for actor in self._actors]
        for name in ("x_m", "y_m", "speed_mps", "heading_rad"):
            columns[name] = [actor[name][tick] for tick in ticks for actor in self._actors]
        return columns

    def to_dataframe(self):
        """The trajectory as a pandas.DataFrame."""
        return _dataframe(self.trajectory)

    def to_html(self) -> str:
        """A page that plays the test and shows beliefs and intentions. It needs no network."""
        if self._page is None:
            raise ValueError("a drive that was recorded elsewhere has no agents to be shown")
        return self._page()

    def _repr_html_(self) -> Optional[str]:
        return None if self._page is None else _framed(self._page())


class Scenario:
    """A scenario that is ready to run; `load_scenario` makes it."""

    def __init__(self, native: Any):
        self._native = native

    def __repr__(self) -> str:
        return f"<scenario {self.name}>"

    @property
    def name(self) -> str:
        return self._native.name

    @property
    def world(self) -> str:
        """ "crossing", "motorway", … """
        return self._native.world

    @property
    def behaviours(self) -> list[str]:
        return self._native.behaviours

    @property
    def agents(self) -> list[int]:
        """The numbers of agents that it compares unless others are given."""
        return self._native.agents

    @property
    def tests(self) -> int:
        return self._native.tests

    @property
    def seed(self) -> int:
        return self._native.seed

    @property
    def warnings(self) -> list[Diagnostic]:
        """Of what is allowed but unusual."""
        return self._native.warnings

    def run(
        self,
        behaviour: Optional[str] = None,
        *,
        agents: int = 1,
        test: int = 0,
        seed: Optional[int] = None,
        assertions: Optional[Iterable[Path]] = None,
        print: Optional[Callable[[str], None]] = None,
    ) -> Test:
        """Runs one test, by default of the first behaviour; the same arguments give the same test. `test` counts from
        0; `print` receives what agents print; `assertions` are files, by default the scenario's."""
        chosen = behaviour or self.behaviours[0]
        agents, test, seed = _test(agents, test, seed)
        said = self._native.run(chosen, agents, test, seed, print, _assertion_files(assertions))
        return Test(said, lambda: self._native.page(chosen, agents, test, seed))

    def compare(
        self,
        *,
        tests: Optional[int] = None,
        agents: Union[None, int, Iterable[int]] = None,
        seed: Optional[int] = None,
        threads: Optional[int] = None,
        assertions: Optional[Iterable[Path]] = None,
        metrics: bool = False,
        store: Optional[Path] = None,
        resume: bool = False,
        progress: Optional[Callable[[int, int], None]] = None,
    ) -> Comparison:
        """Runs `tests` tests of each behaviour with each number of agents, by default the scenario's, on `threads`
        threads (all that there are); the results do not depend on their number. They are judged by the `assertions`, by
        default the scenario's. `store` is the path of a results store that keeps all tests; it must not exist unless
        `resume` lets it be continued. `progress(done, total)` is called some times a second."""
        given = None if agents is None else list(agents) if isinstance(agents, Iterable) else [agents]
        said = self._native.compare(
            whole_or_none("tests", tests, 1, _native.MOST_TESTS),
            given if given is None else [whole("agents", each, 1, _native.MOST_AGENTS) for each in given],
            whole_or_none("seed", seed),
            whole("threads", min(os.cpu_count() or 1, _native.MOST_THREADS) if threads is None else threads, 1, _native.MOST_THREADS),
            _assertion_files(assertions),
            metrics,
            os.fspath(store) if store is not None else "",
            resume,
            progress,
        )
        return Comparison(said)

    def episode(self, *, agents: int = 1, test: int = 0, seed: Optional[int] = None) -> Episode:
        """A test whose agents your program drives, tick by tick."""
        return Episode(_native.Episode(self._native, *_test(agents, test, seed)), agents)


class Episode:
    """A test whose agents are driven from Python: look at `percepts`, choose, `step`, until it `is_finished`."""

    def __init__(self, native: Any, agents: int):
        self._native = native
        #: How many agents there are.
        self.agents = agents

    def percepts(self, agent: int = 0) -> list[Structure]:
        """What the agent, from 0, perceives now."""
        return self._native.percepts(whole("agent", agent, 0, self.agents - 1))

    def step(self, *actions: Any) -> list[Optional[str]]:
        """One tick with an action of each agent: a literal ("move(right)") or None. Returns why each of them has
        failed; None: it has not."""
        return self._native.step(list(actions))

    @property
    def is_finished(self) -> bool:
        return self._native.is_finished

    @property
    def result(self) -> dict[str, Any]:
        """succeeded, ended_by, ticks, met_by (the agents that met the precondition), scores (of each agent)."""
        return self._native.result()


class Comparison:
    """The results of a comparison: a row for each behaviour with each number of agents."""

    def __init__(self, said: dict):
        #: One dict a row: behaviour, agents, tests, successes, errored, each measure (None: it has no value) with the
        #: ends of its 95 % interval (`accuracy_low`, `accuracy_high`), and the number of tests with each verdict
        #: ("avoidability.fail").
        self.rows: list[dict[str, Any]] = said["rows"]
        self._kills: list[dict[str, Any]] = said["kills"]
        #: False if it was ended before all tests were run.
        self.is_complete: bool = said["is_complete"]
        #: The files that `jaywalk compare --csv` and `--json` write.
        self.csv: str = said["csv"]
        self.json: str = said["json"]

    def measure(self, name: str) -> dict[tuple[str, int], Optional[float]]:
        """A measure of each row, by (behaviour, agents); `measures()` lists the names."""
        known = _native.measures()
        if name not in known:
            raise KeyError(f"there is no measure '{name}', only {', '.join(known)}")
        return {(row["behaviour"], row["agents"]): row[name] for row in self.rows}

    @property
    def accuracy(self) -> dict[tuple[str, int], Optional[float]]:
        """The share of successful tests in per cent, by (behaviour, agents)."""
        return self.measure("accuracy")

    def to_dataframe(self):
        """The rows as a pandas.DataFrame."""
        return _dataframe(self.rows)

    @property
    def kills(self):
        """How many tests killed each defect of the AV, as a pandas.DataFrame: behaviour, agents, defect, tests, kills,
        healthy_failures (in how many tests the AV without the defect is to blame itself; these kill nothing),
        first_kill_median (how many tests it takes to kill it with a chance of a half; missing: no test does). A test
        kills a defect if with the same seed the AV without it breaks no assertion, and with it one that it could have
        kept. Empty unless the scenario was loaded with `defects`."""
        columns = ("behaviour", "agents", "defect", "tests", "kills", "healthy_failures", "first_kill_median")
        return _dataframe(self._kills, columns=columns)

    def _table(self) -> list[tuple[str, ...]]:
        lines = [("behaviour", "agents", "tests", "successes", "accuracy %", "95 %", "errored")]
        for row in self.rows:
            cells = [f"{row[name]:.1f}" if row[name] is not None else "–" for name in ("accuracy", "accuracy_low", "accuracy_high")]
            numbers = (str(row[name]) for name in ("agents", "tests", "successes"))
            lines.append((row["behaviour"], *numbers, cells[0], f"{cells[1]} to {cells[2]}", str(row["errored"])))
        return lines

    def __str__(self) -> str:
        lines = self._table()
        widths = [max(len(line[i]) for line in lines) for i in range(len(lines[0]))]
        return "\n".join(
            "  ".join(cell.ljust(width) if i == 0 else cell.rjust(width) for i, (cell, width) in enumerate(zip(line, widths)))
            for line in lines
        )

    def __repr__(self) -> str:
        return f"<comparison of {len(self.rows)} rows>"

    def _repr_html_(self) -> str:
        head, *body = self._table()
        rows = "".join("<tr>" + "".join(f"<td>{html.escape(cell)}</td>" for cell in line) + "</tr>" for line in body)
        return "<table><tr>" + "".join(f"<th>{cell}</th>" for cell in head) + f"</tr>{rows}</table>"


class Store:
    """A results store, the file in which a comparison keeps its tests; nothing is written."""

    def __init__(self, path: Path):
        self._path = os.fspath(path)
        self._native = _native.Store.open(self._path)

    def __repr__(self) -> str:
        return f"<store {self._path} with {len(self)} tests>"

    def __len__(self) -> int:
        return self._native.count

    @property
    def is_complete(self) -> bool:
        """Whether it has all tests of the experiment."""
        return self._native.is_complete

    def tests(
        self,
        *,
        behaviour: Optional[str] = None,
        agents: Optional[int] = None,
        succeeded: Optional[bool] = None,
        errored: Optional[bool] = None,
    ) -> list[dict[str, Any]]:
        """Its tests, or those that are wanted, in the order of their ids: id, behaviour, agents, test, vehicle,
        succeeded, errored, ended_by, ticks, score."""
        return self._native.tests(behaviour, whole_or_none("agents", agents, 0, _native.MOST_AGENTS), succeeded, errored)

    def to_dataframe(self):
        """All tests as a pandas.DataFrame."""
        return _dataframe(self.tests())

    def table(self, name: str = "results"):
        """A table of the file as a pandas.DataFrame: "results" (a row for each test: how it ended, which assertions
        failed), "tests", "actors", "observations", "events", "drops", "assessments", ...; docs/reference/store.md
        describes them."""
        uri = pathlib.Path(self._path).absolute().as_uri() + "?mode=ro"
        with contextlib.closing(sqlite3.connect(uri, uri=True)) as database:
            known = [row[0] for row in database.execute("SELECT name FROM sqlite_master WHERE type IN ('table', 'view')")]
            if name not in known:
                raise KeyError(f"the store has no table '{name}', only {', '.join(sorted(known))}")
            rows = database.execute(f'SELECT * FROM "{name}"')
            columns = [each[0] for each in rows.description]
            return _dataframe(rows.fetchall(), columns=columns)

    def test(self, id: int) -> Test:
        """All that was seen of a test, with its verdicts. It is run again if the store has not kept its scenes."""
        id = whole("id", id)
        return Test(self._native.test(id), lambda: _native.stored_page(self._path, id))

    def comparison(self) -> Comparison:
        """The summary of all tests."""
        return Comparison(self._native.comparison())


def load_scenario(
    scenario: Path,
    params: Optional[Mapping[str, Any]] = None,
    *,
    behaviours: Union[None, str, Path, Mapping[str, str], Iterable[Path]] = None,
    preset: Optional[str] = None,
    av: Optional[Callable[[], AV]] = None,
    defects: Union[None, str, Iterable[str]] = None,
    policies: Iterable[Path] = (),
    include: Iterable[Path] = (),
) -> Scenario:
    """Makes a scenario ready to run.

    `scenario` is the path of a YAML file, the name of one that comes with Jaywalk ("paper"), or a text of YAML with a
    line break. `params` replace its values: {"world.av.speed": 2}. `behaviours` are names of the scenario's, paths of
    programs, or a dict of names and texts of AgentSpeak; by default all of the scenario's. `av` is a class derived from
    AV that drives instead of the scenario's AV. `defects` ("latency", "short-range=12", or "all") makes each test of a
    comparison run with the AV as it is and with each of these defects of it. Errors: jaywalk.Error with the places of
    all mistakes.
    """
    if av is not None and not callable(av):
        raise TypeError(f"av is a class derived from AV, found {av!r}")
    text = None
    name = os.fspath(scenario)
    if "\n" in name:
        name, text = "text.yaml", name
    else:
        name = shipped(name, "scenarios")
    sets = [f"{key}={json.dumps(value)}" for key, value in (params or {}).items()]
    if defects is not None:
        sets.append("experiment.defects=" + (defects if isinstance(defects, str) else ",".join(defects)))
    include = [os.fspath(each) for each in include]
    with tempfile.TemporaryDirectory(prefix="jaywalk-") as folder:
        chosen = []
        if isinstance(behaviours, Mapping):
            for behaviour, program in behaviours.items():
                if not re.fullmatch(r"\w[\w-]*", behaviour):
                    raise ValueError(f"a behaviour's name has letters, digits, '_' and '-', found {behaviour!r}")
                path = pathlib.Path(folder, behaviour + ".asl")
                path.write_text(program, encoding="utf-8")
                chosen.append(str(path))
            include.append(folder)
        elif behaviours is not None:
            single = isinstance(behaviours, (str, os.PathLike))
            chosen = [os.fspath(each) for each in ([behaviours] if single else behaviours)]
            include += dict.fromkeys(os.path.dirname(os.path.abspath(each)) for each in chosen if is_path(each))
        native = _native.Scenario.load(
            name, text, preset, sets, chosen, [os.fspath(each) for each in policies], include, data_folder(), av
        )
    return Scenario(native)


def compare(scenario: Union[Scenario, Path], params: Optional[Mapping[str, Any]] = None, **options: Any) -> Comparison:
    """Loads a scenario and compares its behaviours: the options of `load_scenario` and of `Scenario.compare`."""
    if isinstance(scenario, Scenario):
        return scenario.compare(**options)
    names = ("behaviours", "preset", "av", "defects", "policies", "include")
    loading = {name: options.pop(name) for name in names if name in options}
    return load_scenario(scenario, params, **loading).compare(**options)


def open(path: Path) -> Store:
    """A results store. Errors: jaywalk.Error if it is none, is damaged or being written."""
    return Store(path)


def judge(
    trace: Any,
    assertions: Optional[Iterable[Path]] = None,
    *,
    scenario: Union[Scenario, Path] = "paper",
) -> Test:
    """Judges a drive that was recorded elsewhere, on the scenario's ground, by the files `assertions` or the scenario's.

    `trace` is a pandas.DataFrame, the path of a CSV file, or a text of CSV with a line break: a row for each actor at
    each time, with the columns time (s), actor, kind, x, y (m) and perhaps heading, speed, length, width, event. The names
    may have units (`time_s`, `x_m`), so that a test's `to_dataframe()` can be given.
    """
    name = "trace.csv"
    if hasattr(trace, "to_csv"):
        text = trace.to_csv(index=False)
    elif "\n" in os.fspath(trace):
        text = trace
    else:
        name = os.fspath(trace)
        text = pathlib.Path(name).read_text(encoding="utf-8")
    ground = scenario if isinstance(scenario, Scenario) else load_scenario(scenario)
    return Test(_native.judge(name, text, ground._native, _assertion_files(assertions)), None)


def measures() -> dict[str, str]:
    """The measures of a comparison, and what each means."""
    return _native.measures()


def _test(agents: Any, test: Any, seed: Any) -> tuple[int, int, Optional[int]]:
    return whole("agents", agents, 1, _native.MOST_AGENTS), whole("test", test, 0, _native.MOST_TESTS - 1), whole_or_none("seed", seed)


def _assertion_files(assertions: Optional[Iterable[Path]]) -> Optional[list[str]]:
    if assertions is None:
        return None
    given = [assertions] if isinstance(assertions, (str, os.PathLike)) else assertions
    return [shipped(each, "scenarios/assertions") for each in given]


def _dataframe(content: Any, **options: Any):
    try:
        import pandas
    except ImportError:
        raise ImportError("a DataFrame needs pandas: apt install python3-pandas, or pip install pandas") from None
    return pandas.DataFrame(content, **options)


def _framed(page: str) -> str:
    return f'<iframe style="width: 100%; height: 640px; border: 0" srcdoc="{html.escape(page)}"></iframe>'
