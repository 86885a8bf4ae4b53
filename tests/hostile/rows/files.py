"""Places that are no files, links, devices, and texts that other files name."""

from row import Row, WALKER

CROSSING = {"walker.asl": WALKER, "s.yaml": "behaviours: [walker.asl]\n"}
BINARY = bytes(i * 7919 % 251 for i in range(100_000))
AGENT = {"agent.asl": "!go. +!go <- .print(done).\n"}


def included(name, directive, code, says, **more):
    return Row(name, ["run", "p/agent.asl"], code, says, {"p/agent.asl": directive + "\n!go. +!go <- .print(done).\n"}, **more)


ROWS = [
    Row("a file that there is not", ["run", "none.asl"], 2, "no such file"),
    Row("a folder for a program", ["run", "."], 2, "error:"),
    Row("a name without an ending", ["run", "agent"], 2, "error:", {"agent": "!a.\n"}),
    Row("a device for a program", ["run", "/dev/zero"], 2, "error:"),
    Row("a link to a device for a program", "ln -s /dev/zero a.asl; jaywalk run a.asl", 2, "a.asl"),
    Row("a program of a device's memory", "ln -s /proc/self/mem a.asl; jaywalk check a.asl", 2, "a.asl"),
    Row("a link to itself", "ln -s a.asl a.asl; jaywalk check a.asl", 2, "a.asl"),
    Row("a file that may not be read", "chmod 0 agent.asl; [ -r agent.asl ] && exit 2; jaywalk run agent.asl", 2, "", AGENT),
    Row("a name that is no UTF-8", "printf '!a. +!a.' >\"$(printf 'a\\377.asl')\"; jaywalk run \"$(printf 'a\\377.asl')\"", 0),
    Row("a behaviour whose name is no UTF-8", "cp walker.asl \"$(printf 'w\\377.asl')\"; jaywalk compare s.yaml --tests 1 --agents 1"
        " --behaviours \"$(printf 'w\\377.asl')\" --json out.json", 2, "error:", CROSSING),
    Row("a name of 5,000 letters", ["run", "a" * 5000 + ".asl"], 2, "error:"),
    Row("an empty name", ["run", ""], 2, "error:"),
    included("a program that includes itself", '{ include("agent.asl") }', 2, "include"),
    included("an include that there is not", '{ include("none.asl") }', 2, "agent.asl:1"),
    included("an include of a folder", '{ include(".") }', 2, "agent.asl:1"),
    included("an include of a device", '{ include("/dev/zero") }', 2, "agent.asl:1"),
    Row("two that include each other", ["check", "a.asl"], 2, "include",
        {"a.asl": '{ include("b.asl") }\n', "b.asl": '{ include("a.asl") }\n'}),
    Row("includes, 100 deep", ["check", "f0.asl"], 2, "include",
        {f"f{i}.asl": f'{{ include("f{i + 1}.asl") }}\n' for i in range(100)} | {"f100.asl": "b.\n"}),
    *(Row(f"10 MB of one letter to {command} as {name}", [command, name], 2, "error:", {name: "a" * 10_000_000})
      for command, name in (("run", "a.asl"), ("check", "a.asl"), ("run", "s.yaml"))),
    *(Row(f"no file {name}", ["run", name], 2, "no such file") for name in ("p.mas2j", "s.yaml")),
    *(Row(f"bytes to {command} as {name}", [command, name], 2, "error:", {name: BINARY}, most=60_000)
      for command, name in (("run", "a.asl"), ("check", "a.asl"), ("run", "p.mas2j"), ("run", "s.yaml"), ("search", "s.yaml"))),
    *(Row(f"a folder to {command} as {name}", [command, name], 2, "error:", {name + "/x": ""})
      for command, name in (("run", "a.asl"), ("run", "p.mas2j"), ("run", "s.yaml"), ("report", "s.gpkg"), ("search", "s.yaml"))),
    Row("a CSV to a folder that there is not", ["compare", "s.yaml", "--csv", "none/x.csv"], 2, "none", CROSSING),
    Row("a CSV to a folder", ["compare", "s.yaml", "--csv", "."], 2, "error:", CROSSING),
    Row("a CSV to a full device", ["compare", "s.yaml", "--tests", "2", "--agents", "1", "--csv", "/dev/full"], 1, "/dev/full", CROSSING),
    Row("a store on a device", ["run", "s.yaml", "--store", "/dev/null"], 2, "/dev/null", CROSSING),
    Row("a page to a place that may not be written", ["compare", "s.yaml", "--report", "/proc/page.html"], 2, "/proc", CROSSING),
    Row("output that nobody can take", "jaywalk compare s.yaml --tests 2 --agents 1 >/dev/full", 1, "standard output", CROSSING),
    Row("a pipe that nobody writes to", "mkfifo a.asl; jaywalk run a.asl", 2, "a.asl: error: a pipe that nobody writes to"),
    Row("a pipe for a scenario that nobody writes to", "mkfifo s.yaml; jaywalk check s.yaml", 2, "s.yaml: error: a pipe that nobody writes to"),
    Row("a pipe that somebody writes to, in the end", "mkfifo a.asl; (sleep 1; echo '!a. +!a <- .print(read).' >a.asl) & jaywalk run a.asl", 0, "read"),
    Row("a pipe whose writer takes its time", "mkfifo a.asl; (sleep 3; echo '!a. +!a <- .print(read).') >a.asl & jaywalk run a.asl", 0, "read"),
    Row("a pipe that never ends", "mkfifo a.asl; yes >a.asl & jaywalk run a.asl; code=$?; kill $!; exit $code", 2, "a.asl: error: larger than"),
    Row("a pipe for a store", "mkfifo s.gpkg; jaywalk report s.gpkg", 2, "s.gpkg: error: this is no regular file"),
    Row("a name with control characters", "printf '!a.' >\"$(printf 'a\\033[2J.asl')\"; jaywalk check \"$(printf 'a\\033[2J.asl')\"", 0, "\\x1b", never="\x1b"),
    Row("a missing name with control characters", ["run", "a\x1b[2J.asl"], 2, "no such file", never="\x1b"),
    included("an include of secrets", '{ include("/etc/passwd") }', 2, ["agent.asl:1", "outside the folders"], never="root:"),
    included("an include above the program's folder", '{ include("../../../../../../../../etc/passwd") }', 2, ["agent.asl:1", "outside the folders"], never="root:"),
    included("an include of what a process has", '{ include("/proc/self/environ") }', 2, ["agent.asl:1", "not a plain file"], never="PATH="),
    Row("an include through a link", "ln -s /etc/passwd l.asl; jaywalk run agent.asl", 2, ["agent.asl:1", "outside the folders"],
        {"agent.asl": '{ include("l.asl") }\n'}, never="root:"),
    Row("10 MB of one letter for a project", ["run", "p.mas2j"], 2, "p.mas2j:1", {"p.mas2j": "a" * 10_000_000}),
]
