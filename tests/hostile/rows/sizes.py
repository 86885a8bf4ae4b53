"""Large texts and terms: read in time, or refused with the limit."""

from row import checked, program

MANY = 70_000

ROWS = [
    checked("a list of 300,000 elements", "b([" + "1," * 299_999 + "1]).\n", 0),
    checked("300,000 facts", "".join(f"fact({i}).\n" for i in range(300_000)), 0),
    checked("20,000 plans for one goal", "".join(f"+!a({i}).\n" for i in range(20_000)), 0),
    checked("a body of 60,000 formulas", "!a. +!a <- " + "b; " * 59_999 + "b.\n", 0),
    checked("a body of 100,000 formulas", "!a. +!a <- " + "b; " * 99_999 + "b.\n", 2,
            "more than 65535 formulas in a body"),
    checked("70,000 annotations", "b[" + "".join(f"a({i})," for i in range(MANY)) + "z].\n", 0),
    checked("50,000 names", "".join(f"n{i}.\n" for i in range(50_000)), 0),
    checked("a disjunction of 900 parts", "r :- " + " | ".join(f"b({i})" for i in range(900)) + ".\n", 0),
    program("a text that doubles 60 times", "!go. +!go <- !d(\"x\",60). -!go[error(E)] <- .print(E).\n"
            "+!d(S,0) <- .print(end). +!d(S,N) <- .concat(S,S,T); !d(T,N-1).\n", 0, ""),
    program("a list that doubles 60 times", "!go. +!go <- !d([x],60). -!go[error(E)] <- .print(E).\n"
            "+!d(S,0) <- .print(end). +!d(S,N) <- .concat(S,S,T); !d(T,N-1).\n", 0, "", seconds=60),
    program("a range to a billion", "!go. +!go <- .findall(X,.range(X,1,1000000000),L). -!go[error(E)] <- .print(E).\n", 0, "limit", seconds=60),
    program("a structure of a billion arguments", "!go. +!go <- .length(L,1000000000); T =.. [f|L]. -!go[error(E)] <- .print(failed,E).\n", 0, "failed"),
    program("a power beyond doubles", "!go. +!go : X = 10 ** 10 ** 10 <- .print(X).\n", 0, "Infinity"),
    program("division by zero", "!go. +!go <- X = 1/0; Y = 1 mod 0; Z = 1 div 0; .print(X,Y,Z). -!go <- .print(failed).\n", 0, ""),
    program("a random number of no range", "!go. +!go <- .random([],X). -!go <- .print(failed).\n", 0, "failed"),
    program("the billionth element", "!go. +!go <- .nth(1000000000,[a],X). -!go <- .print(failed).\n", 0, "failed"),
    program("a part of a text behind its end", "!go. +!go <- .substring(\"abc\",S,5,-1). -!go <- .print(failed).\n", 0, "failed"),
    checked("a structure of 70,000 arguments", "b(" + "1," * (MANY - 1) + "1).\n", 2, "65"),
    checked("a goal of 70,000 arguments", "!b(" + "1," * (MANY - 1) + "1).\n", 2, "65"),
    checked("a body of 70,000 variables", "+!a <- " + "; ".join(f"?b(_X{i})" for i in range(MANY)) + ".\n", 2, "65"),
    program("structures from lists of 70,000", "!go. +!go <- .findall(X,.range(X,1,70000),L); T =.. [f,L,[]]; .print(T). -!go[error(E)] <- .print(failed,E).\n", 0, "failed"),
    checked("a rule of 70,000 variables", "r :- " + " & ".join(f"b(_X{i})" for i in range(MANY)) + ".\n", 2, "nested deeper than 1000 levels"),
]
