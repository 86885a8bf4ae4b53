"""Experiments of searches."""

from row import Row

SOUND = ("sut: {kind: lane-keeping, controller: paper-rate}\nfitness: {measure: max_oob, fails_at: 0.95}\n"
         "budget: {tests: 3, virtual_s: 0}\ngenerators: [random]\nrepetitions: 1\n")


def search(name, code, says, *changes, text=None, options=()):
    """The sound experiment with texts replaced."""
    if text is None:
        text = SOUND
    for before, after in changes:
        assert before in text
        text = text.replace(before, after)
    return Row(name, ["search", "search.yaml", "--threads", "1", *options], code, says, {"search.yaml": text})


ANSWER = '{"time": [0, 1], "speed": [1.5, 2]}'
ASKED = """sut:
  kind: external
  command: [sh, program.sh]
  timeout_s: 9
  inputs: {gas: [0, 100]}
  signals: {speed: [0, 100]}
  requirements: {slow: always speed < 50}
fitness: {measure: robustness}
budget: {tests: 3, virtual_s: 0}
generators: [random]
"""


def asked(name, code, says, answer, *changes):
    """A search of a program that always answers so; None: not at all."""
    text = ASKED
    for before, after in changes:
        assert before in text
        text = text.replace(before, after)
    # The number is repeated, so that nothing waits for further lines.
    program = f'''while read -r line; do n=${{line##*\\"test\\":}}; echo '{answer}' | sed "s/^{{/{{\\"test\\":${{n%%[!0-9]*}},/"; done'''
    if answer is None:
        program = "while read -r line; do sleep 60; done"
    return Row(name, ["search", "search.yaml", "--threads", "1"], code, says, {"search.yaml": text, "program.sh": program + "\n"})


ROWS = [
    search("a sound search", 0, "random"),
    search("an empty search", 2, "search.yaml", text=""),
    search("a search that is a list", 2, "search.yaml:1", text="[sut]\n"),
    search("a system that there is not", 2, "search.yaml:1", ("lane-keeping", "lane-keepnig")),
    search("a controller that there is not", 2, "search.yaml:1", ("paper-rate", "paper-rat")),
    search("a measure that there is not", 2, "search.yaml:2", ("max_oob", "max_obo")),
    search("no generator", 2, "search.yaml:4", ("[random]", "[]")),
    search("a generator that there is not", 2, "search.yaml:4", ("[random]", "[randon]")),
    search("a generator twice", 2, "search.yaml:4", ("[random]", "[random, random]")),
    search("no budget", 2, "search.yaml:3", ("tests: 3", "tests: 0")),
    search("a negative budget", 2, "search.yaml:3", ("tests: 3", "tests: -3")),
    search("a budget beyond all numbers", 2, "search.yaml:3", ("tests: 3", "tests: 1e308")),
    search("repetitions of none", 2, "search.yaml:5", ("repetitions: 1", "repetitions: 0")),
    search("a failure at what is no number", 2, "search.yaml:2", ("0.95", ".nan")),
    search("a scenario that there is not", 2, "search.yaml:1", ("{kind: lane-keeping, controller: paper-rate}",
           "{kind: crossing, scenario: missing.yaml, behaviour: x}"), ("max_oob", "exercised")),
    search("a key that there is not", 2, "search.yaml:6", ("repetitions: 1\n", "repetitions: 1\nsede: 1\n")),
    search("an external system without a program", 2, "command", ("{kind: lane-keeping, controller: paper-rate}", "{kind: external}")),
    asked("a sound program", 0, "0 of 1, > 3", ANSWER),
    asked("a program that answers NaN", 1, "expected a JSON object", ANSWER.replace("1.5", "NaN")),
    asked("a program that answers too few values", 1, "'speed' has 1 values, 'time' has 2", ANSWER.replace("[1.5, 2]", "[2]")),
    asked("a program that answers no numbers", 1, "'speed' has \"fast\" where a number", ANSWER.replace("1.5", '"fast"')),
    asked("a program that answers times that stand still", 1, "'time' does not rise", ANSWER.replace("[0, 1]", "[1, 1]")),
    asked("a program that hangs", 1, "no answer within 0.1 s", None, ("timeout_s: 9", "timeout_s: 0.1")),
    asked("an input without values", 2, "search.yaml:5", ANSWER, ("[0, 100]", "[]")),
    asked("an input beyond all numbers", 2, "search.yaml:5", ANSWER, ("[0, 100]", "[0, 1e300]")),
    asked("a requirement that is none", 2, "search.yaml:7", ANSWER, ("always speed < 50", "always speed")),
    asked("a requirement without end", 2, "search.yaml:7", ANSWER, ("always speed < 50", "(" * 4000 + "speed < 50")),
    asked("a requirement of nothing", 2, "search.yaml:7", ANSWER, ("always speed < 50", "")),
    asked("a measure that needs bounds", 2, "needs 'harmless' and 'worst'", ANSWER, ("robustness", "slow_robustness")),
    search("--set of what there is not", 2, "--set", options=("--set", "budget.test=3")),
    search("a report to a folder that there is not", 2, "none/", options=("--report", "none/page.html")),
    Row("a search of a scenario", ["search", "s.yaml"], 2, "s.yaml", {"s.yaml": "behaviours: [a.asl]\n", "a.asl": "!a. +!a.\n"}),
    Row("a comparison of a search", ["compare", "s.yaml"], 2, "found an experiment of searches", {"s.yaml": SOUND}),
]
