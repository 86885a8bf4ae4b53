"""Messages to oneself, to nobody, of nothing, and too many."""

from row import program, project

ROWS = [
    program("a message to nobody", "!go. +!go <- .send(nobody,tell,x); .print(done). -!go <- .print(failed).\n", 0, ""),
    program("a performative that there is not", "!go. +!go <- .my_name(N); .send(N,shout,x).\n", 0, "no applicable plan"),
    program("a message with a free variable", "!go. +!go <- .my_name(N); .send(N,tell,X). -!go <- .print(failed).\n", 0, ""),
    program("a message whose content is a number", "!go. +!go <- .my_name(N); .send(N,achieve,3); .print(done). -!go <- .print(failed).\n", 0, ""),
    program("a plan that is none told how", "!go. +!go <- .my_name(N); .send(N,tellHow,\"+!x <- \"). -!go <- .print(failed).\n", 0, ""),
    program("asking oneself for ever", "!go. +!go <- .my_name(N); .send(N,askOne,x(Y),Y,100); .print(Y). -!go <- .print(failed).\n", 0, ""),
    program("a list of receivers that has itself a list", "!go. +!go <- .send([[a]],tell,x). -!go <- .print(failed).\n", 0, ""),
    program("a broadcast to nobody", "!go. +!go <- .broadcast(tell,x); .print(done).\n", 0, "done"),
    project("two agents that answer each other for ever", "MAS m { agents: a; b; }", 1, "", "--max-cycles", "1000",
            files={"a.asl": "!go. +!go <- .send(b,achieve,go).", "b.asl": "+!go <- .send(a,achieve,go)."}),
    project("a round that never ends", "MAS m { agents: a; b; }", 1, "", "--timeout", "1",
            files={"a.asl": "!go. +!go <- .send(b,achieve,go).", "b.asl": "+!go <- .send(a,achieve,go)."}),
]
