"""Files of assertions."""

from row import Row, scenario

ONE = "assertions:\n  - id: a\n    source: a rule\n    precondition: eventually in_zone\n    requirement: {}\n"


def rules(name, text, code, says, *options):
    return scenario(name, "assertions: rules.yaml\n", code, says, *options, files={"rules.yaml": text})


def requirement(name, text, code=2, says="rules.yaml:5"):
    return rules(name, ONE.format(text), code, says)


ROWS = [
    requirement("a sound assertion", "always closest > 0", 0, ""),
    requirement("an unknown signal", "always closets > 0", says="closest"),
    requirement("an operator without its right side", "always closest >"),
    requirement("a bracket that is not closed", "always (closest > 0"),
    requirement("a number for a condition", "3"),
    requirement("a condition for a number", "always (closest > 0) + 1 > 2"),
    requirement("an interval from late to early", "eventually[5, 1] closest > 0"),
    requirement("an interval of negative time", "eventually[-1, 5] closest > 0"),
    requirement("an interval without end", "eventually[0, 1e999] closest > 0"),
    requirement("brackets, 100,000 deep", "(" * 100_000 + "closest > 0" + ")" * 100_000, says="rules.yaml"),
    requirement("negations, 100,000 in a row", "not " * 100_000 + "in_zone", says="rules.yaml"),
    requirement("operators, 100,000 in a row", "in_zone" + " and in_zone" * 100_000, says="rules.yaml"),
    requirement("a zero byte", "\"always \\0\""),
    requirement("division by zero", "always closest / 0 > 0", 0, ""),
    requirement("a list for an expression", "[1, 2]"),
    rules("an empty file", "", 2, "rules.yaml"),
    rules("a file without assertions", "assertions: []\n", 2, "rules.yaml"),
    rules("an id that is no atom", ONE.format("always closest > 0").replace("id: a", "id: A b"), 2, "rules.yaml:2"),
    rules("an id twice", ONE.format("always closest > 0") + ONE.format("always closest > 0")[12:], 2, "rules.yaml:6"),
    rules("a severity that there is not", ONE.format("always closest > 0") + "    severity: grave\n", 2, "rules.yaml:6"),
    rules("a parameter that is no number", ONE.format("always closest > 0") + "    parameters: {p: .nan}\n", 2, "rules.yaml:6"),
    rules("a parameter with a signal's name", ONE.format("always closest > 0") + "    parameters: {closest: 1}\n", 2, "rules.yaml:6"),
    scenario("a file of assertions that there is not", "assertions: none.yaml\n", 2, "none.yaml"),
    scenario("assertions in a folder", "assertions: .\n", 2, "scenario.yaml:1"),
    scenario("an assertion to judge that there is not", "assertions: {file: rules.yaml, judge: [b]}\n", 2, "'b'",
             files={"rules.yaml": ONE.format("always closest > 0")}),
    scenario("--fail-on of nothing", "", 2, "--fail-on", "--fail-on", "nothing"),
    scenario("--fail-on of an unknown measure", "", 2, "--fail-on", "--fail-on", "acuracy<40"),
]
