"""Programs that ask for all memory: what asks fails, the agent's other plans and other agents go on, and the process
stays near the limit."""

from row import Row, program, project

MB = 64
BOUND = ("--max-memory", str(MB), "--timeout", "250")  # the clock is a net: no row ends by it
FULL = "memory limit is reached"
HANDLED = "-!go[error(E),error_msg(M)] <- .print(E,\": \",M)."


def held(name, text, says=FULL, *options, **more):
    """It ends by itself."""
    return program(name, text, 0, says, *BOUND, *options, most_mb=MB * 1.2, **more)


def stormy(name, text, says=FULL, cycles=400_000):
    """It never ends: a limit of cycles does that, soon, however many intentions there are."""
    ends = f"reached the limit of {cycles} cycles"
    return program(name, text + " !other. +!other <- .wait(5); .print(alive).\n", 1, [says, "alive", ends], *BOUND, "--max-cycles", str(cycles),
                   most_mb=MB * 1.2)


def society(name, files, says, code=0, *options, most_mb=MB * 1.2, **more):
    return project(name, "MAS m { agents: " + " ".join(f"{file[:-4]};" for file in files) + " }", code, says, *BOUND, *options,
                   files=files, most_mb=most_mb, **more)


SHARED = "!go(a,60). +!go(_,0). +!go(T,N) <- {}; !go(f(T,T),N-1).\n"  # a small term, and a text that no memory holds
BRIEF = {"most_mb": MB, "most": 120_000, "seconds": 2}

ROWS = [
    program("arithmetic on a term that shares its parts", SHARED.format("X = T-1"), 0, "which is not a number", *BOUND, **BRIEF),
    program("a constraint on a term that shares its parts", SHARED.format("!!fails(T)") + "+!fails(T) <- X = T; X == 1.\n", 0,
            ["Constraint", "un={T=f(f(f("], *BOUND, **BRIEF),
    program("a constraint before many formulas", "!go(50). +!go(0). +!go(N) <- !!fails; !go(N-1). +!fails <- 1 == 2" + "; a(1)" * 20_000 + ".\n", 0,
            "Constraint (1 == 2); a(1); a(1)", *BOUND, **BRIEF),
    program("a constraint among many variables", "!go. +!go <- " + "".join(f"V{i} = \"{'x' * 900}\"; " for i in range(3000)) + "1 == 2.\n"
            "-!go[error_msg(M)] <- .length(M,L); if (L < 5000) { .print(short) } else { .print(L) }.\n", 0, "short", *BOUND, "--no-check", **BRIEF),
    program("a goal with a term that shares its parts, and no plan", SHARED.format("!!unknown(T)"), 0, "unknown(f(f(", *BOUND, **BRIEF),
    program("a failure within a goal with such a term", SHARED.format("!!fails(T)") + "+!fails(_) <- .fail.\n", 0, "goals: fails(a)", *BOUND, **BRIEF),
    program("warnings about a body that has itself in itself", "!a. !b. !c.\n+!Y <- X = { (2-X) \\== d(X,math.max(X,1)); c }; X = [].\n", 0,
            "arithmetic on ...{ ((2-X)", *BOUND, "--no-check", most_mb=MB, most=100_000, seconds=1),
    program("arithmetic with a term that contains itself and an unknown", "!go. +!go <- X = b(X**Y); +held(X). -!go[error_msg(M)] <- .print(M).\n",
            0, "nested", *BOUND, "--no-check", never="arithmetic on", **BRIEF),
    held("beliefs without end", "!go(0). +!go(N) <- +b(N); !go(N+1).\n"),
    held("goals without end", "!go. +!go <- !go; a.\n"),
    held("goals without end, handled", f"!top. +!top <- !go. +!go <- !go; a. {HANDLED.replace('-!go', '-!top')}\n", "limit: the agent's " + FULL),
    held("a term that doubles", "!go. +!go <- !d(x). +!d(T) <- !d(f(T,T)); a.\n"),
    held("a list without end", "!go. +!go <- !l([]). +!l(L) <- !l([x|L]); a.\n", most=3_000_000),
    program("a list that doubles", "!go. +!go <- !l([1,2,3]). +!l(L) <- .concat(L,L,M); !l(M).\n", 0, "memory",
            *BOUND, most_mb=MB * 1.5),  # the message has texts of the list
    program("the text of a term that shares its parts", "!go(a,0). +!go(T,N) : N < 60 <- !go(t(T,T),N+1). +!go(T,_) <- .print(T).\n", 0, "memory limit",
            *BOUND, most_mb=MB * 2.2),  # a text has 64 MB of its own, twice while it grows
    held("solutions without end", "!go. +!go <- .findall(f(X,Y,X), .range(X,1,1000) & .range(Y,1,1000), _).\n", "memory"),
    held("plans without end", "!go(0). +!go(N) <- .concat(\"+!p\",N,\" <- true.\",S); .add_plan(S); !go(N+1).\n", "memory limit"),
    held("names without end", "!go(0). +!go(N) <- .concat(\"a\",N,S); .term2string(T,S); !go(N+1).\n", "all agents together"),
    held("functors without end", "!go(0). +!go(N) <- .concat(\"a\",N,S); T =.. [S,[1],[]]; !go(N+1).\n", "all agents together"),
    held("long names without end", "!start. +!start <- !grow(\"a\",0). +!grow(S,K) : K < 18 <- .concat(S,S,U); !grow(U,K+1). +!grow(S,_) <- !go(S,0).\n"
         "+!go(S,N) <- .concat(S,N,U); .term2string(T,U); !go(S,N+1).\n", "memory limit"),
    held("a text of many names", "!start. +!start <- !grow(\"a\",0). +!grow(S,K) : K < 21 <- .concat(S,\",\",S,U); !grow(U,K+1). +!grow(S,_) <- .concat(\"[\",S,\"]\",U);\n"
         ".term2string(T,U); .print(read).\n", "memory limit"),
    Row("a hundred agents that print long texts in one round", "jaywalk run p.mas2j --threads 4 | wc -c", 0, "",
        {"a.asl": "!go(x,0). +!go(T,N) : N < 20 <- !go(t(T,T),N+1). +!go(T,_) <- .print(T).\n", "p.mas2j": "MAS m { agents: a #100; }"}, most_mb=400, seconds=60),
    stormy("intentions without end", "!go. +!go <- !!go; !!go."),
    stormy("messages to itself without end", "!go. +!go <- .my_name(N); .send(N,achieve,go); .send(N,achieve,go).", "memory"),
    stormy("a failure that makes a failure", "!go. +!go <- !go; a. -!go <- !go; a.", "alive"),
    society("messages without end", {
        "a.asl": "!go. +!go <- .send(b,achieve,x); .send(b,achieve,y); !go. " + HANDLED + "\n",
        "b.asl": "!wait. @w[atomic] +!wait <- .wait(50000); .print(unharmed). +!x. +!y.\n",
        "c.asl": "!see(20000). +!see(0) <- .print(unharmed). +!see(N) <- !see(N-1).\n"}, ["b has no memory left for messages", "[c] unharmed", "[b] unharmed"], 0, "--max-cycles", "1500000"),
    society("four agents that are too much together", {
        **{f"a{i}.asl": "!go(0). +!go(N) <- +b(N); !go(N+1).\n" for i in range(4)},
        "c.asl": "!see(20000). +!see(0) <- .print(unharmed). +!see(N) <- !see(N-1).\n"}, ["all agents together", "[c] unharmed"]),
    stormy("events without end", "!go. +!go <- +b; -b; !!go; !!go.", cycles=700_000),
    society("agents without end", {"a.asl": "!go. +!go <- .create_agent(n,\"a.asl\"); !go. -!go[error_msg(M)] : .my_name(a) <- .print(M); .print(unharmed). -!go.\n"},
            ["memory limit of all agents together", "[a] unharmed"],
            most_mb=MB * 2, most=4_000_000),  # what a system keeps about each agent is not counted
]
