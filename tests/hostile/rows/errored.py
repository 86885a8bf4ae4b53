"""Comparisons in which one behaviour or the controller does harm: its tests end errored and are counted, the
others' rows stand."""

from row import WALKER, Row

LIMITS = ["--max-cycles", "2000", "--max-inferences", "200000", "--max-memory", "64"]
RULES = "assertions:\n  - {id: hit, source: a rule, precondition: eventually in_zone, requirement: always closest > 0}\n"
LOOP = "!go. +!go <- !go.\n"
BURNS = ("p(1). p(2). p(3). p(4). p(5). p(6). p(7). p(8). p(9).\n"
         "r :- p(A) & p(B) & p(C) & p(D) & p(E) & p(F) & p(G) & p(H) & A+B+C+D+E+F+G+H > 99.\n"
         "!go. +!go : r. -!go <- !wait; !go. +!wait <- move(forward). -!wait.\n")


def compared(name, bad, *options, code=1, says="2 of 4 tests ended errored", limits=None, **more):
    """Two tests of a walker, two of the bad one, whose row has no result."""
    words = ["compare", "s.yaml", "--tests", "2", "--agents", "1", "--no-check", *(LIMITS if limits is None else limits), *options]
    files = {"walker.asl": WALKER, "bad.asl": bad, "s.yaml": "behaviours: [walker.asl, bad.asl]\n", "rules.yaml": RULES}
    return Row(name, words, code, ["walker", says], files, most=100_000, **more)


def driven(name, script, says="errored", code=0, *options):
    text = ("world:\n  tick: 0.5\n  length: 30\n  road_end: 29\n  av: {model: external, command: [sh, av.sh], speed_mps: 9}\n"
            "behaviours: [walker.asl]\n")
    return Row(name, ["compare", "s.yaml", "--tests", "2", "--agents", "1", "--no-check", *options], code, says,
               {"walker.asl": WALKER, "s.yaml": text, "av.sh": script}, most=100_000)


ROWS = [
    compared("a behaviour that loops", LOOP),
    compared("a behaviour that stops the system", "!go. +!go <- .stopMAS.\n"),
    compared("a behaviour that stops the system with a code", "!go. +!go <- .stopMAS(0,3).\n"),
    compared("a behaviour that burns inferences", BURNS),
    compared("a behaviour that floods its memory", "!go(0). +!go(N) <- +b(N); !go(N+1).\n", limits=["--max-memory", "16"]),
    compared("a behaviour that floods its intentions", "!go. +!go <- !!go; !!go.\n", limits=["--max-memory", "16"]),
    compared("a behaviour that storms itself with messages", "!go. +!go <- .my_name(N); .send(N,achieve,go); .send(N,achieve,go).\n", limits=["--max-memory", "16"]),
    compared("an errored test as a failure", LOOP, "--fail-on", "errored>0"),
    compared("errored tests in strict comparisons", LOOP, "--strict"),
    compared("errored tests in a store, CSV, JSON and a page", LOOP, "--store", "s.gpkg", "--csv", "o.csv", "--json", "o.json", "--report", "o.html"),
    driven("a controller that fails in every test", "read -r x; exit 1\n", "2 of 2 tests ended errored", 1),
    driven("a controller that fails once in two starts",
           "if [ -e ran ]; then rm ran; exit 1; fi; touch ran; while read -r x; do echo '{\"acceleration\":-1}'; done\n",
           "1 of 2 tests ended errored", 0, "--threads", "1"),
    compared("errored tests in JUnit", LOOP, "--assertions", "rules.yaml", "--junit", "out.xml"),
    Row("one test that floods its memory", ["run", "s.yaml", "--max-memory", "16", "--no-check"], 1,
        "memory", {"bad.asl": "!go(0). +!go(N) <- +b(N); !go(N+1).\n", "s.yaml": "behaviours: [bad.asl]\n"}, most=100_000),
]
