"""Nesting, in texts and at run time."""

from row import checked, program

ROWS = [
    checked("brackets, 100,000 deep", "b(" + "(" * 100_000 + "1" + ")" * 100_000 + ").\n", 2, "nest"),
    checked("lists, 100,000 deep", "b(" + "[" * 100_000 + "]" * 100_000 + ").\n", 2, "nest"),
    checked("structures, 100,000 deep", "b(" * 100_000 + "1" + ")" * 100_000 + ".\n", 2, "nest"),
    checked("negations, 100,000 deep", "r :- " + "not " * 100_000 + "b.\n", 2, "parentheses"),
    checked("signs, 100,000 deep", "r(X) :- X = " + "-" * 100_000 + "1.\n", 2, "expected a term"),
    checked("blocks, 100,000 deep", "+!a <- " + "if (b) { " * 100_000 + "c" + " }" * 100_000 + ".\n", 2, "nest"),
    checked("plans in plans, 100,000 deep", "+!a <- " + "+{ +b <- " * 100_000 + "c" + " }" * 100_000 + ".\n", 2, "nest"),
    checked("annotations, 100,000 deep", "b" + "[a" * 100_000 + "]" * 100_000 + ".\n", 2, "nest"),
    checked("powers, 100,000 in a row", "r(X) :- X = 1" + "**1" * 100_000 + ".\n", 2, "nest"),
    checked("conjunctions, 100,000 in a row", "r :- a" + " & a" * 100_000 + ".\n", 2, "nest"),
    checked("comments in comments", "/* " * 100_000 + "*/ b.\n", 0),
    program("a rule that recurses 100,000 deep", "r(0). r(N) :- N > 0 & r(N-1).\n"
            "!go. +!go <- ?r(100000); .print(done).\n", 0, "done"),
    program("a goal that recurses 100,000 deep", "!go(100000). +!go(0) <- .print(done). +!go(N) <- !go(N-1); true.\n", 0, "done"),
    program("a term that nests as it runs", "!go. +!go <- !wrap(0,1). -!go[error(E)] <- .print(E).\n"
            "+!wrap(X,N) : N < 5000 <- !wrap(f(X),N+1). +!wrap(X,N) <- .print(X).\n", 0, "", most=30_000),
    program("queries within queries", "n(0). n(N) :- N > 0 & .findall(x,n(N-1),[x]).\n"
            "!go. +!go <- ?n(1000). -!go[error(E)] <- .print(E).\n", 0, "limit"),
    program("a rule that calls itself first", "r(X) :- r(X).\n!go. +!go <- ?r(1). -!go[error(E)] <- .print(E).\n", 0, "limit"),
    program("an error 3,000 goals deep is told in brief",
            "!go(3000). +!go(0) <- .fail. +!go(N) <- !go(N-1).\n", 0, most=8000),
]
