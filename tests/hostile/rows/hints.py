"""Each hint that names an option: a command that gives it, and the same command as the hint says."""

import pathlib
import re

from row import WALKER, Row

RULES = "assertions:\n  - {id: hit, source: a rule, precondition: eventually in_zone, requirement: always closest > 0}\n"
FILES = {
    "walker.asl": WALKER,
    "rules.yaml": RULES,
    "s.yaml": "world: {length: 30, road_end: 29}\nbehaviours: [walker.asl]\n",
    "braking.yaml": "world: {tick: 0.5, length: 30, road_end: 29, av: {model: braking, speed_mps: 9}}\nbehaviours: [walker.asl]\n",
    "av.yaml": "world:\n  tick: 0.5\n  length: 30\n  road_end: 29\n  av: {model: external, command: [sh, av.sh], speed_mps: 9}\n"
               "behaviours: [walker.asl]\n",
    "av.sh": "while read -r x; do echo '{\"acceleration\":-1}'; done\n",
    "roads.yaml": "sut: {kind: lane-keeping, controller: paper-rate}\nfitness: {measure: max_oob, fails_at: 0.95}\n"
                  "budget: {tests: 3, virtual_s: 0}\ngenerators: [random]\nrepetitions: 1\n",
    "met.yaml": "preset: paper\n",
    "chained.yaml": "preset: as-published-program\nbehaviours: [proximity]\n",
    "learn.yaml": "preset: paper\nbehaviours: [chooser.asl]\nlearning: {learner: q-table}\n",
    "chooser.asl": "!go.\n@l[learned(way)] +!go <- !pass; !go.\n@r[learned(way)] +!go <- move(forward); !go.\n"
                   "+!pass <- stay. -!pass <- !pass. -!go <- !pass; !go.\n",
    "walk.yaml": "sut: {kind: crossing, scenario: braking.yaml, behaviour: walker.asl, agents: 1, starts: searched}\n"
                 "fitness: {measure: exercised, fails_at: 1}\nbudget: {tests: 3, virtual_s: 0}\ngenerators: [random]\nrepetitions: 1\n",
    "drive.csv": "time,actor,kind,x,y\n0,av,vehicle,0,0\n0.5,av,vehicle,0,3\n1,av,vehicle,0,6\n",
    "own/list.asl": '!go. +!go <- .list_files("../other", L); .print(L). -!go <- .print(failed).\n',
    "own/save.asl": '!go. +!go <- .save_agent("../other/new.asl").\n',
    "own/up.asl": '{ include("../other/b.asl") }\n!go. +!go : b(X) <- .print(believes, X).\n',
    "own/by_link.asl": '{ include("link.asl") }\n!go. +!go : b(X) <- .print(believes, X).\n',
    "own/inc.asl": '!go. +!go <- .include("../other/b.asl"); ?b(X); .print(believes, X).\n',
    "own/make.asl": '!go. +!go <- .create_agent(eve, "../other/b.asl"); .print(made).\n',
    "own/mapped.asl": '{ include("$lib/b.asl") }\n!go. +!go : b(X) <- .print(believes, X).\n',
    "other/b.asl": "b(1).\n",
    "own/p.mas2j": 'MAS p { agents: b; aslSourcePath: "../other"; }\n',
    "java.mas2j": "MAS j { environment: some.Env\n agents: a walker.asl; }\n",
    "a.asl": "!go. +!go <- .print(done).\n",
    "a_tests.asl": '{ include("$jasonJar/test/jason/inc/tester_agent.asl") }\n@[test] +!one <- true.\n',
}
COMPARE = "compare s.yaml --tests 2 --agents 1 --no-check --quiet --threads 1 "
STORE = f"jaywalk {COMPARE} --store s.gpkg || exit 99; "


def hint(command, said, better, code=0, says="", before="", first=None):
    """`command` says `said`; `better`, which does as it says, does not, and ends with the code. HINTED in it is the option
    that the hint gives (up to " allows it")."""
    shell = (f"{before}jaywalk {command} >hint 2>&1; {'' if first is None else f'[ $? = {first} ] || exit 98; '}cat hint; "
             f"grep -qF -- '{said}' hint || exit 97; hinted=$(grep -oE -- '--allow-[a-z]+ [^ ]+' hint | head -1); jaywalk "
             + better.replace("HINTED", "$hinted") + f" >now 2>&1; code=$?; cat now; grep -qF -- '{said}' now && exit 96; exit $code")
    return Row(f"{said}: {command[:60]}", shell, code, says, FILES)


COVERED = [
    hint("run own/up.asl", "allows it", "run own/up.asl HINTED", says="believes1", first=2),
    hint("run own/by_link.asl", "allows it", "run own/by_link.asl HINTED", says="believes1", before="ln -s ../other/b.asl own/link.asl; ", first=2),
    hint("run own/by_link.asl", "allows it", "run own/by_link.asl HINTED", says="believes1",
         before="ln -s ../other own/there; ln -s there/b.asl own/link.asl; ", first=2),
    hint("run own/inc.asl", "allows it", "run own/inc.asl HINTED", says="believes1"),
    hint("run own/make.asl", "allows it", "run own/make.asl HINTED", says="made"),
    hint("run own/list.asl", "allows it", "run own/list.asl HINTED", says="b.asl", before="cd own; sed -i s,../other,$PWD/../other, list.asl; cd ..; "),
    hint("run ../own/save.asl", "allows it", "run ../own/save.asl HINTED; ls ../other/new.asl", before="mkdir work; cd work; ", says="other/new.asl"),
    hint("run own/p.mas2j", "allows it", "run own/p.mas2j HINTED", first=2),
    hint("run own/mapped.asl", "--map", "run own/mapped.asl --map '$lib=other' --allow-read other", says="believes1", first=2),
    hint("run own/mapped.asl --map other", "--map '\"'\"'$jasonJar=FOLDER", "run own/mapped.asl --map '$lib=other'", says="believes1", first=2),
    hint("run java.mas2j --timeout 2 --max-ticks 2", "--ignore-java", "run java.mas2j --ignore-java --max-cycles 50", code=1, first=2),
    hint("replay o.gpkg --test 0", "--allow-commands", "replay o.gpkg --test 0 --html page.html --allow-commands",
         before="jaywalk compare av.yaml --tests 1 --agents 1 --no-check --quiet --store-level summary --store o.gpkg || exit 99; ", first=2),
    hint(COMPARE + "--store s.gpkg", "--resume", COMPARE + "--store s.gpkg --resume", before=STORE, first=2),
    hint("search roads.yaml --quiet --store r.gpkg", "--resume", "search roads.yaml --quiet --store r.gpkg --resume",
         before="jaywalk search roads.yaml --quiet --store r.gpkg; ", first=2),
    hint("learn learn.yaml --agents 1 --tests 4 --quiet", "--policy", "learn learn.yaml --agents 1 --tests 4 --quiet --policy learned.json", first=2),
    hint("learn learn.yaml --agents 1 --tests 4 --quiet --policy p.json", "--resume", "learn learn.yaml --agents 1 --tests 8 --quiet --policy p.json --resume",
         before="jaywalk learn learn.yaml --agents 1 --tests 4 --quiet --policy p.json || exit 99; ", first=2),
    hint(COMPARE + "--junit o.xml", "--assertions", COMPARE + "--junit o.xml --assertions rules.yaml", first=2),
    hint("judge s.gpkg", "--assertions", "judge s.gpkg --assertions rules.yaml", before=STORE, first=2),
    hint("judge --trace drive.csv --scenario s.yaml", "--assertions", "judge --trace drive.csv --scenario s.yaml --assertions rules.yaml", first=2),
    hint("judge --trace drive.csv --metrics", "--scenario", "judge --trace drive.csv --metrics --scenario s.yaml", first=0),
    hint(COMPARE + "--fail-on hit.fail\\>0", "--assertions", COMPARE + "--assertions rules.yaml --fail-on hit.fail\\>9", first=2),
    hint("compare braking.yaml --tests 1 --agents 1 --no-check --quiet --defects latency", "--assertions",
         "compare braking.yaml --tests 1 --agents 1 --no-check --quiet --defects latency --assertions rules.yaml", first=2),
    hint("compare braking.yaml --tests 1 --agents 1 --no-check --quiet --kills k.csv", "--defects",
         "compare braking.yaml --tests 1 --agents 1 --no-check --quiet --kills k.csv --defects latency --assertions rules.yaml", first=2),
    hint("compare chained.yaml --tests 2 --agents 1 --quiet --shard 1/2 --store c.gpkg", "(--behaviours, --agents)",
         "compare chained.yaml --tests 2 --quiet --store c.gpkg --behaviours proximity --agents 1", first=2),
    hint("check --dump-code s.yaml", "--dump-code shows", "check --dump-code a.asl", first=2),
    hint(COMPARE + "--seet 3", "did you mean", COMPARE + "--seed 3", first=2),
    hint("compare s.yaml --set speed", "--set world.av.speed=8", COMPARE + "--set world.av.speed=8", first=2),
    hint("export s.gpkg --format xls", "--list", "export s.gpkg --list", before=STORE, first=2),
    hint("replay m.gpkg --test 70", "without --test", "replay m.gpkg --html page.html", code=0,
         before="jaywalk compare met.yaml --tests 8 --agents 1 --no-check --quiet --behaviours random_behaviour --store m.gpkg || exit 99; ", first=2),
    hint("replay s.gpkg", "--test names", "replay s.gpkg --test 1 --html page.html", before=STORE, first=2),
]
COVERED += [
    hint("compare braking.yaml --tests 1 --agents 1 --no-check --quiet --with-kills k.csv --assertions rules.yaml --defects latency", "--behaviours and --agents",
         "compare braking.yaml --tests 1 --agents 2 --no-check --quiet --with-kills k.csv --assertions rules.yaml --defects latency", before=(
             "jaywalk compare braking.yaml --tests 1 --agents 1 --no-check --quiet --defects latency --assertions rules.yaml --kills k.csv || exit 99; "), first=2),
    hint("compare braking.yaml --tests 1 --agents 2 --no-check --quiet --with-kills k.csv --assertions rules.yaml --defects short-range", "--defects names those of both",
         "compare braking.yaml --tests 1 --agents 2 --no-check --quiet --with-kills k.csv --assertions rules.yaml --defects latency", before=(
             "jaywalk compare braking.yaml --tests 1 --agents 1 --no-check --quiet --defects latency --assertions rules.yaml --kills k.csv || exit 99; "), first=2),
    hint("search roads.yaml --quiet --kills k.csv", "--defects names them",
         "search walk.yaml --quiet --kills k.csv --defects latency",
         before="echo 'assertions: {file: rules.yaml}' >>braking.yaml; ", first=2),
    hint("merge m.gpkg 1.gpkg --quiet", "--resume", "compare s.yaml --tests 2 --agents 1 --no-check --quiet --store m.gpkg --resume",
         before="jaywalk " + COMPARE + "--shard 1/2 --store 1.gpkg || exit 99; "),
    hint("replay s.gpkg --test 0 --tick 3", "without --png", "replay s.gpkg --test 0 --tick 3 --png o.png", before=STORE, first=2),
    hint(COMPARE + "--resume", "without --store", COMPARE + "--store s.gpkg --resume", first=2),
    hint(COMPARE + "--store s.gpkg --retry-errors", "without --resume", COMPARE + "--store s.gpkg --resume --retry-errors", first=2),
]

# Hints that other tests follow (cli/interrupt, cli/search, places: what was interrupted goes on; exports/postgis; a file that the
# command writes), and what is no hint but a text of --help.
ELSEWHERE = ("shows how to write it", "--resume goes on", "--resume runs the others", "To get the others", "write such a file", "writes such a file",
             "--schema gives another one", "draw", "/proc", "says otherwise", "esmini plays", "names the options", "Judges the tests", "kills the defect")


def hints_in_sources():
    """The literals that advise an option."""
    root = pathlib.Path(__file__).parents[3]
    advice = re.compile(r"(--[a-z-]+|\{\}) (allows|lets|names|goes on|continues|gives|leaves? out|runs|shows|keeps)|with(out)? --|write it as --|unless --"
                        r"|example --|say where it is with --")
    for top in ("interpreter", "env", "experiment", "search", "tools"):
        for path in sorted((root / top).rglob("*.cpp")):
            text = re.sub(r'"\s*\n\s*"', "", path.read_text())
            for literal in re.findall(r'"((?:[^"\\]|\\.)*)"', text):
                if "--" in literal and " " in literal and advice.search(literal):
                    yield path.relative_to(root), literal


SAID = [row.name.split(": ")[0].replace("'\"'\"'", "'") for row in COVERED]
UNTRIED = [f"{path}: {literal}" for path, literal in hints_in_sources()
           if not any(said in literal for said in SAID) and not any(piece in literal for piece in ELSEWHERE)]

ROWS = [*COVERED,
        Row("hints in the sources that no row tries", "cat untried; [ ! -s untried ]", 0, files={"untried": "\n".join(UNTRIED)}, never="--")]
