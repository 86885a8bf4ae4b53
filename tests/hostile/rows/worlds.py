"""Worlds that are programs and do not do what they ought to. Scripts of the shell: `ask` reads a question."""

from row import Row, project

ASK = "ask() { read -r question; }\n"
HELLO = """ask; printf '{"n":0,"protocol":1,"name":"w","version":"1"}\\n'\n"""
INIT = """ask; printf '{"n":1}\\n'\n"""
AGENT = "!go. +!go <- wave(1); !go. -!go <- !go.\n"
EMPTY = "n=1; while ask; do printf '{\"n\":%d}\\n' $((n += 1)); done\n"


def world(name, script, code, says, *options, files=None, **more):
    return Row(name, ["run", "robot.asl", "--environment", "sh world.sh", "--environment-timeout", "1", "--max-ticks", "100",
                      "--no-check", *options], code, says,
               {"robot.asl": AGENT, "world.sh": ASK + script, **(files or {})}, **more)


def answers(name, tick, says, **more):
    """It says this, behind the number, to the first tick, and nothing is there any more afterwards."""
    return world(name, HELLO + INIT + f"ask; cat answer\nask\n", 1, says,
                 files={"answer": '{"n":2,' + tick + "}\n"}, **more)


def started(name, command, code, says, **more):
    return Row(name, ["run", "robot.asl", "--environment", command], code, says, {"robot.asl": AGENT}, **more)


def left_behind(name, script, code, says):
    """What the world starts is gone when we are; `child` has the numbers of those processes."""
    command = ("jaywalk run robot.asl --environment 'sh world.sh' --environment-timeout 1 --max-ticks 5 --no-check; code=$?; "
               "for pid in $(cat child); do for i in 1 2 3 4 5 6 7 8 9 10; do kill -0 $pid 2>/dev/null || break; sleep 0.1; done; "
               "grep -s State /proc/$pid/status | grep -v zombie && echo outlived; done; exit $code")
    return Row(name, command, code, says, {"robot.asl": AGENT, "world.sh": ASK + script}, never="outlived")


ROWS = [
    world("a sound world", HELLO + INIT + EMPTY, 1, "reached the limit of 100 ticks"),
    started("no command", "", 2, "expected a command"),
    started("a command of blanks", "   ", 2, "expected a command"),
    started("a quote without an end", "sh 'world", 2, "--environment"),
    started("a program that there is not", "./none", 2, "./none"),
    started("a program that is a folder", ".", 2, "."),
    started("a world that ends at once", "true", 2, "exit code 0"),
    world("a world that fails at once", "exit 3\n", 2, "exit code 3"),
    world("a world that dies of a signal", "ask; kill -SEGV $$\n", 2, "signal 11"),
    world("a hello of garbage", "ask; echo hello\n", 2, ["line 1 of its output", "expected a JSON object"]),
    world("a hello that is a list", "ask; echo '[1]'\n", 2, "expected a JSON object"),
    world("another protocol", "ask; echo '{\"n\":0,\"protocol\":9}'\n", 2, "version 9"),
    world("no time passes", HELLO.replace('"version":"1"', '"version":"1","tick_ms":0'), 2, "tick_ms"),
    world("time without end", HELLO.replace('"version":"1"', '"version":"1","tick_ms":1e999'), 2, "expected a JSON object"),
    world("a world that never begins", HELLO + "ask; sleep 100\n", 1, "no answer within 1 s"),
    world("a world that reads nothing more", HELLO + "sleep 100\n", 1, "no answer within 1 s"),
    world("a world that ends in a tick", HELLO + INIT + "ask; exit 4\n", 1, "exit code 4"),
    world("a world that dies in a tick", HELLO + INIT + "ask; echo 'no beer' >&2; kill -KILL $$\n", 1, ["signal 9", "no beer"]),
    world("errors without end", HELLO + "ask; exec yes >&2\n", 1, "no answer within 1 s"),
    world("many errors", HELLO + INIT + "ask; head -c 3000000 /dev/zero | tr '\\0' e >&2; printf '{\"n\":2,\"finished\":true}\\n'; ask\n",
          0, "bytes)"),
    world("an answer without end", HELLO + "ask; exec yes | tr -d '\\n'\n", 1, "no answer within 1 s"),
    world("an answer of 20 MB", HELLO + "ask; head -c 20000000 /dev/zero | tr '\\0' x; echo\n", 1, "longer than 16 MB",
          "--environment-timeout", "20"),
    world("an answer 100,000 brackets deep", HELLO + "ask; head -c 100000 /dev/zero | tr '\\0' '['; echo; ask\n", 1, "line 2"),
    world("an answer of bytes", HELLO + "ask; printf '\\377\\376\\n'; ask\n", 1, "line 2"),
    world("control characters", HELLO + "ask; printf '\\033[2J\\n'; ask\n", 1, "line 2", never="\x1b"),
    world("two answers for a question", HELLO + INIT + 'ask; printf \'{"n":2}\\n{"n":3}\\n\'; ask\n', 1, "it also wrote"),
    world("the answer to another question", HELLO + "ask; echo '{\"n\":7}'; ask\n", 1, "it answers n 7, expected 1"),
    world("an answer without a number", HELLO + "ask; echo '{}'; ask\n", 1, "there is no 'n'"),
    world("a line before the question", "echo hello\n" + HELLO + "ask\n", 2, "hello"),
    world("a world that says why", HELLO + "ask; echo '{\"n\":1,\"error\":\"no robot\"}'; ask\n", 1, "it reports 'no robot'"),
    answers("percepts that are a list", '"percepts":["p"]', "'percepts' is not an object"),
    answers("a percept that is a number", '"percepts":{"robot":[1]}', "not a text: 1"),
    answers("a percept of a variable", '"percepts":{"robot":["p(1, X)"]}', ["line 3", "a percept of robot:1:6"]),
    answers("a percept of nothing", '"percepts":{"robot":[""]}', "a percept of robot:1:1"),
    answers("a percept that is a program", '"percepts":{"robot":["p. !go. +!go <- .stopMAS"]}', "a percept of robot:1:2"),
    answers("a percept 100,000 brackets deep", '"percepts":{"robot":["p(' + "[" * 100_000 + '"]}', "a percept of robot:1:"),
    answers("1,000 wrong percepts", '"percepts":{"robot":[' + ",".join(f'"p({i}, X)"' for i in range(1000)) + "]}", "a percept of robot:1",
            most=30_000),
    answers("a percept of another agent", '"percepts":{"robo":["p"]}', "did you mean 'robot'?"),
    answers("the end of another action", '"done":[{"id":77}]', "no action 77 is under way"),
    answers("the end of an action twice", '"done":[{"id":1},{"id":1}]', "no action 1 is under way"),
    answers("a negative action", '"done":[{"id":-1}]', "expected {"),
    answers("a percept that is an internal action", '"percepts":{"robot":[".stopMAS"]}', "a percept of robot:1:1"),
    answers("a percept of a sum", '"percepts":{"robot":["p(1+1)"]}', "a percept of robot:1:3"),
    answers("a percept of 70,000 arguments", '"percepts":{"robot":["p(' + "1," * 70_000 + '1)"]}', "a percept of robot:1:"),
    answers("a reason that is a list", '"done":[{"id":1,"failed":[]}]', "is not a text"),
    answers("an end that is a number", '"finished":1', "is not true or false"),
    left_behind("processes of a world that ends well",
                "sleep 1000 >&2 & echo $! >child\n" + HELLO + INIT + "ask; printf '{\"n\":2,\"finished\":true}\\n'; ask\n", 0, ""),
    left_behind("processes of a world that hangs", "sleep 1000 & echo $! $$ >child\n" + HELLO + "ask; sleep 1000\n", 1, "no answer"),
    left_behind("a world that does not listen to bye",
                "trap '' TERM HUP INT; echo $$ >child\n" + HELLO + INIT +
                "ask; printf '{\"n\":2,\"finished\":true}\\n'; while :; do sleep 0.1; done\n", 0, ""),
    left_behind("processes of processes", "(sleep 1000 & sleep 1000 & echo $! >child; wait) & " + HELLO + "ask; exit 1\n", 1, "exit code 1"),
    project("a process without a command", "MAS m { environment: process agents: a; }", 2, ["project.mas2j:1:22", "in quotes"]),
    project("a process whose command is a name", "MAS m { environment: process(world) agents: a; }", 2, "in quotes"),
    project("a process whose command is empty", 'MAS m { environment: process("") agents: a; }', 2, "project.mas2j:1:22"),
    project("a project's program that there is not", 'MAS m { environment: process("./none") agents: a; }', 2,
            ["project.mas2j:1:22", "./none"]),
]
