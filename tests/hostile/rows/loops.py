"""Programs that do not end: an option, a limit or the loop's own end ends them."""

from row import Row, program, scenario

ROWS = [
    program("a goal that calls itself last", "!go. +!go <- !go.\n", 1, "timeout", "--timeout", "1"),
    program("a goal that calls itself first", "!go. +!go <- !go; a.\n", 1, "", "--max-cycles", "1000"),
    program("two goals that call each other", "!a. +!a <- !b. +!b <- !a.\n", 1, "", "--max-cycles", "1000"),
    program("a loop without end", "!go. +!go <- while (true) { +x(1); -x(1) }.\n", 1, "", "--timeout", "1"),
    program("an empty loop", "!go. +!go <- while (true) { }.\n", 1, "", "--max-cycles", "1000"),
    program("a belief that brings itself back", "b. +b <- -b; +b.\n", 1, "", "--max-cycles", "1000"),
    program("a failure that tries again", "!go. +!go <- .fail. -!go <- !go.\n", 1, "", "--max-cycles", "1000"),
    program("a wait that never ends", "!go. +!go <- .wait(\"+never\"); .print(x).\n", 0),
    program("waiting for a year", "!go. +!go <- .wait(31536000000); .print(done).\n", 0, "done"),
    program("a negative wait", "!go. +!go <- .wait(-1); .print(done). -!go <- .print(failed).\n", 0, ""),
    program("a rule without end", "n(X) :- n(Y) & X = Y+1.\nn(0).\n!go. +!go <- ?n(X) & false. -!go[error(E)] <- .print(E).\n", 0, "limit", seconds=60),
    program("a rule that burns inferences", "p(1). p(2). p(3). p(4). p(5). p(6). p(7). p(8). p(9). p(0).\n"
            "r :- p(A) & p(B) & p(C) & p(D) & p(E) & p(F) & p(G) & p(H) & p(I) & false.\n"
            "!go. +!go : r. -!go[error(E)] <- .print(E).\n", 1, "", "--timeout", "0.2"),
    program("a regular expression that backtracks", "!go. +!go <- .concat(\"aaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaa\",\"b\",S);"
            " .replace(S,\"(a+)+c\",\"x\",T); .print(done). -!go <- .print(failed).\n", 0, ""),
    program("an agent that makes agents that make agents", "!go. +!go <- .create_agent(x,\"agent.asl\"); .my_name(_).\n", 1, "", "--timeout", "1"),
    program("an agent that kills itself", "!go. +!go <- .my_name(N); .kill_agent(N); .print(no).\n", 0, "", never="no\n"),
    program("an agent that stops the system", "!go. +!go <- .stopMAS; .print(x).\n", 0),
    program("an agent that stops the system with a code", "!go. +!go <- .stopMAS(0,1).\n", 1),
    program("every intention dropped", "!go. +!go <- .drop_all_intentions; .print(no).\n", 0),
    program("an intention that drops itself", "!go. +!go <- .drop_intention(go); .print(x).\n", 0),
    program("an intention that suspends itself", "!go. +!go <- .suspend; .print(no).\n", 0, never="no"),
    program("a plan that removes itself", "!go. @p +!go <- .remove_plan(p); .print(done); !go. -!go <- .print(gone).\n", 0, "gone"),
    program("a plan that adds itself", "!go. +!go <- .add_plan({+!go <- true}); !go.\n", 1, "", "--max-cycles", "1000"),
    Row("a test that does not end", ["test", "agent.asl", "--max-cycles", "1000"], 1, "",
        {"agent.asl": "@[test] +!t <- !t.\n"}),
    Row("a test that takes too long", ["test", "agent.asl", "--timeout", "1"], 1, "",
        {"agent.asl": "@[test] +!t <- !l. +!l <- !l.\n"}),
    Row("a test that stops the system", ["test", "agent.asl"], 1, "", {"agent.asl": "@[test] +!t <- .stopMAS.\n"}),
    program("conditions of goals about a term that contains itself",
            "!s. +!s <- for (.range(I,1,50)) { !!w }. +!w <: X = f(X) & .ground(X) <- while (true) { .count(x,_) }.\n", 0,
            "the goal w[source(self)] fails, since its condition cannot be decided: a term", "--max-cycles", "400", seconds=4),
    scenario("a pedestrian who reasons for ever within a tick", "behaviours: [bad.asl]\n", 1, "error:", "--no-check",
             files={"bad.asl": "!go. +!go <- !go.\n"}, seconds=60),
]
