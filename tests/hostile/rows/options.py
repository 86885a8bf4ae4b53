"""Words of the command line."""

from row import WALKER, Row

FILES = {"walker.asl": WALKER, "s.yaml": "behaviours: [walker.asl]\n", "a.asl": "!go. +!go <- .print(done).\n"}


def words(name, code, says, *rest):
    return Row(name, list(rest), code, says, FILES)


ROWS = [
    words("no command", 2, "a command is missing"),
    words("a command that there is not", 2, "did you mean", "rum", "a.asl"),
    words("an option before the command", 2, "unknown option", "--quiet", "run", "a.asl"),
    words("an option that there is not", 2, "did you mean", "run", "a.asl", "--tiemout", "3"),
    words("an option without its value", 2, "--seed", "run", "a.asl", "--seed"),
    words("no file", 2, "error:", "run"),
    words("two files", 2, "error:", "run", "a.asl", "a.asl"),
    words("a seed that is a word", 2, "--seed", "run", "a.asl", "--seed", "x"),
    words("a negative seed", 2, "--seed", "run", "a.asl", "--seed", "-1"),
    words("a seed beyond all numbers", 2, "--seed", "run", "a.asl", "--seed", "99999999999999999999"),
    words("no threads", 2, "--threads", "compare", "s.yaml", "--threads", "0"),
    words("a time limit of none", 2, "--timeout", "run", "a.asl", "--timeout", "0"),
    words("a time limit that is no number", 2, "--timeout", "run", "a.asl", "--timeout", "nan"),
    words("a time limit without end", 2, "--timeout", "run", "a.asl", "--timeout", "inf"),
    words("a level that there is not", 2, "--log-level", "run", "a.asl", "--log-level", "loud"),
    words("a colour that there is not", 2, "--color", "run", "a.asl", "--color", "red"),
    words("no tests", 2, "--tests", "compare", "s.yaml", "--tests", "0"),
    words("agents of no number", 2, "--agents", "compare", "s.yaml", "--agents", "x"),
    words("a part of no parts", 2, "--shard", "compare", "s.yaml", "--shard", "1/0", "--store", "x.gpkg"),
    words("the third of two parts", 2, "--shard", "compare", "s.yaml", "--shard", "3/2", "--store", "x.gpkg"),
    words("a part without a store", 2, "--store", "compare", "s.yaml", "--shard", "1/2"),
    words("resuming without a store", 2, "--store", "compare", "s.yaml", "--resume"),
    words("a format that there is not", 2, "--format", "compare", "s.yaml", "--format", "xls"),
    words("a preset that there is not", 2, "--preset", "run", "s.yaml", "--preset", "papper"),
    words("a test beyond all", 2, "--test", "run", "s.yaml", "--test", "99999999999999999999"),
    words("an agent for a comparison", 2, "error:", "compare", "a.asl"),
    words("options of a scenario for a program", 2, "error:", "run", "a.asl", "--agents", "3"),
    words("a value that is empty", 2, "error:", "run", "s.yaml", "--set", ""),
    words("a map without a folder", 2, "--map", "run", "a.asl", "--map", "x"),
    words("a billion threads for two tests", 2, "from 1 to 1024", "compare", "s.yaml", "--tests", "2", "--agents", "1", "--threads", "1000000000"),
    words("agents without end", 2, "--agents", "compare", "s.yaml", "--agents", "1..4000000000"),
]
