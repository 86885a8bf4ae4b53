"""External AVs and systems under test that do not do what they ought to. Their programs are scripts of the
shell: `ask` reads a question."""

from row import WALKER, Row

ASK = "ask() { read -r question; }\n"


def controller(name, script, code, says, *options, seconds=30, process="test", **more):
    text = ("world:\n  tick: 0.5\n  length: 30\n  road_end: 29\n"
            f"  av: {{model: external, command: [sh, av.sh], process: {process}, speed_mps: 9}}\nbehaviours: [walker.asl]\n")
    return Row(name, ["run", "scenario.yaml", "--agents", "1", "--no-check", *options], code, says,
               {"walker.asl": WALKER, "scenario.yaml": text, "av.sh": ASK + script}, seconds=seconds, **more)


def sut(name, script, code, says, *options, **more):
    text = ("sut: {kind: external, command: [sh, sut.sh], timeout_s: 1, measures: [max_oob]}\n"
            "fitness: {measure: max_oob, fails_at: 0.95}\nbudget: {tests: 3, virtual_s: 0}\ngenerators: [random]\nrepetitions: 1\n")
    return Row(name, ["search", "search.yaml", "--threads", "1", *options], code, says,
               {"search.yaml": text, "sut.sh": ASK + script}, **more)


def always(answer):
    return f"while ask; do printf '{answer}\\n'; done\n"


ROWS = [
    controller("a sound controller", always('{"acceleration":-1}'), 0, "precondition"),
    controller("a controller that ends at once", "exit 3\n", 1, "av.sh"),
    controller("a controller that dies of a signal", "ask; kill -SEGV $$\n", 1, "signal 11"),
    controller("a controller that there is not", "", 1, "none", "--set", "world.av.command=[./none]"),
    controller("a controller that may not be run", "", 1, "av.sh", "--set", "world.av.command=[./av.sh]"),
    controller("a controller that is a folder", "", 1, "", "--set", "world.av.command=[.]"),
    controller("an answer that is no JSON", always("fast"), 1, "fast"),
    controller("an answer that is a list", always("[1]"), 1, "[1]"),
    controller("an empty answer", always(""), 1, "av.sh"),
    controller("an answer without an acceleration", always('{"a":1}'), 1, "acceleration"),
    controller("an acceleration that is a text", always('{"acceleration":"1"}'), 1, "acceleration"),
    controller("an acceleration beyond doubles", always('{"acceleration":1e999}'), 1, "av.sh"),
    controller("two answers for a question", always('{"acceleration":1}\\n{"acceleration":2}'), 1, "it also wrote"),
    controller("the answer to another question", always('{"step":7,"acceleration":1}'), 1, "step"),
    controller("an answer before the question", "echo hello\n" + always('{"acceleration":1}'), 1, "hello"),
    controller("an answer 100,000 brackets deep", "ask; head -c 100000 /dev/zero | tr '\\0' '['; echo; ask\n", 1, "av.sh"),
    controller("an answer without end", "ask; exec yes | tr -d '\\n'\n", 1, "av.sh"),
    controller("an answer of bytes", always("\\377\\376"), 1, "av.sh"),
    controller("a controller that never answers", "ask; sleep 100\n", 1, "av.sh"),
    controller("a controller that reads nothing", "sleep 100\n", 1, "av.sh"),
    controller("a controller that fails in its second test", "ask; echo '{}'; exit 1\n", 1, "av.sh", process="kept"),
    sut("a sound system", always('{"max_oob":0.4}'), 0, "random"),
    sut("a system that ends at once", "exit 3\n", 1, "sut.sh"),
    sut("a system that never answers", "ask; sleep 100\n", 1, "sut.sh"),
    sut("a system that answers without its measure", always('{"sim_time":1}'), 1, "max_oob"),
    sut("a measure that is a text", always('{"max_oob":"1"}'), 1, "max_oob"),
    sut("a measure beyond doubles", always('{"max_oob":1e999}'), 1, "sut.sh"),
    sut("negative time", always('{"max_oob":0,"sim_time":-1}'), 1, "sim_time"),
    sut("a system that says why it cannot", always('{"error":"no road"}'), 1, "no road"),
    sut("an answer that is no UTF-8", always("\\377"), 1, "sut.sh", "--json", "out.json", "--report", "page.html"),
    controller("an absurd acceleration", always('{"acceleration":1e308}'), 1, "av.sh"),
    controller("an absurd braking", always('{"acceleration":-1e308}'), 1, "av.sh"),
    controller("an answer with control characters", always("\\033[2J"), 1, "av.sh", never="\x1b"),
    sut("two answers of a system for a question", always('{"max_oob":0.1}\\n{"max_oob":0.2}'), 1, "it also wrote"),
]
