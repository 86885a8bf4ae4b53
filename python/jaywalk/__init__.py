# SPDX-License-Identifier: Apache-2.0
"""Jaywalk: agents in AgentSpeak, and a test bench in which they step in front of automated vehicles.

    import jaywalk

    hunter = "+!start ..."                       # a behaviour is a text or a file of AgentSpeak
    scenario = jaywalk.load_scenario("paper", behaviours={"hunter": hunter})
    print(scenario.compare(tests=100))           # how often each behaviour succeeds
    scenario.run("hunter", test=7)               # a notebook plays it
    jaywalk.search(fitness, {"speed": (0, 30)}, budget=200)

`help(jaywalk.Interpreter)` is about agents by themselves, docs/guides/python.md about all of it.
"""
from jaywalk.agents import Agent, Environment, Interpreter, Pending, RunOutcome, check
from jaywalk.bench import (
    AV,
    Comparison,
    Episode,
    Event,
    Scenario,
    Store,
    Test,
    Verdict,
    compare,
    judge,
    load_scenario,
    measures,
    open,
)
from jaywalk.searching import Generator, SearchResult, generators, search
from jaywalk.terms import Atom, Diagnostic, Error, Structure, WrongArgument, literal

__all__ = [
    "AV", "Agent", "Atom", "Comparison", "Diagnostic", "Environment", "Episode", "Error", "Event", "Generator",
    "Interpreter", "Pending", "RunOutcome", "Scenario", "SearchResult", "Store", "Structure", "Test", "Verdict",
    "WrongArgument", "check", "compare", "generators", "judge", "literal", "load_scenario", "measures", "open", "search",
]  # fmt: skip
