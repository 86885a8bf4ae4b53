"""Projects (.mas2j)."""

from row import Row, project

ROWS = [
    project("an empty project", "", 2, "project.mas2j"),
    project("a project without agents", "MAS m { }", 0),
    project("a project without an end", "MAS m { agents: a;", 2, "project.mas2j:1"),
    project("an agent without a program", "MAS m { agents: missing; }", 2, "missing"),
    project("an agent whose program is a folder", "MAS m { agents: a ./.; }", 2, "project.mas2j:1"),
    project("an agent twice", "MAS m { agents: a; a; }", 0),
    project("no agents of a kind", "MAS m { agents: a #0; }", 2, "project.mas2j:1"),
    project("a negative number of agents", "MAS m { agents: a #-1; }", 2, "project.mas2j:1"),
    project("more agents than numbers have", "MAS m { agents: b #99999999999999999999; }", 2, "project.mas2j:1"),
    project("a name of a variable", "MAS m { agents: Agent a.asl; }", 2, "lower-case"),
    project("unknown sections", "MAS m { nothing: x; agents: a; }", 2, "project.mas2j:1"),
    project("an environment of Java", "MAS m { environment: my.Env(1) agents: a; }", 2, "my.Env"),
    project("an architecture of Java", "MAS m { agents: a agentArchClass my.Arch; }", 2, "my.Arch"),
    project("goals that are none", "MAS m { agents: a [goals=\"+!x(\"]; }", 2, "project.mas2j:1"),
    project("beliefs that are none", "MAS m { agents: a [beliefs=\"b(1\"]; }", 2, "project.mas2j:1"),
    project("5,000 lines of agents", "MAS m { agents: " + "".join(f"n{i} b.asl; " for i in range(5_000)) + "}", 0),
    project("a byte that is no UTF-8", b"MAS m { agents: \xff; }", 2, "not UTF-8"),
    project("a zero byte", b"MAS m { agents: a\0; }", 2, "project.mas2j:1"),
    project("comments without end", "MAS m { /* agents: a; }", 2, "project.mas2j:1"),
    project("a project that is a program", "!go. +!go <- .print(x).", 2, "project.mas2j:1"),
    Row("checking a project without programs", ["check", "p.mas2j"], 2, "x.asl", {"p.mas2j": "MAS m { agents: x; }"}),
    project("two million agents", "MAS m { agents: b #2000000; }", 2, "more than 1000000"),
    project("a million agents twice", "MAS m { agents: a b.asl #700000; b #700000; }", 2, "more than 1000000"),
]
