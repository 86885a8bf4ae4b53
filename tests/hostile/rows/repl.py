"""What is typed into the REPL."""

from row import Row


def typed(name, text, code, says="", **more):
    return Row(name, ["repl"], code, says, stdin=text, **more)


ROWS = [
    typed("nothing", "", 0),
    typed("a zero byte", b"\0\n", 2, "error"),
    typed("bytes that are no UTF-8", b"\xff\xfe.\n", 2, "error"),
    typed("a line without its end", "b(1", 2, "error"),
    typed("a command that there is not", ":hepl\n", 2, "did you mean 'help'"),
    typed("a file that there is not", ":load none.asl\n", 2, "none.asl"),
    typed("a line of 10,000 brackets", "?- b(" + "(" * 10_000 + ".\n", 2, "error"),
    typed("a query without end", "n(0). n(X) :- n(Y) & X = Y+1.\n?- n(X) & false.\n", 2, "inferences", seconds=60),
    typed("an agent that stops the system", "!go. +!go <- .stopMAS.\n!go.\n", 0),
    typed("a goal that there is not", "!none.\n", 0),
    typed("after an error it goes on", "b(.\n.print(still_here).\n", 2, "still_here"),
    Row("answers on a pipe that is closed", "printf '.range(X,1,1000000).\\n' >q; (printf '?- .range(X,1,1000000).\\n') | timeout 15 jaywalk repl | head -1", 0, "X"),
]
