"""Stores that others made or damaged. `make` makes a sound one; what follows is done to it."""

from row import WALKER, Row

FILES = {
    "walker.asl": WALKER,
    "rules.yaml": "assertions:\n  - {id: hit, source: a rule, precondition: eventually in_zone, requirement: always closest > 0}\n",
    "s.yaml": "world: {length: 30, road_end: 29}\nbehaviours: [walker.asl]\nassertions: rules.yaml\n",
    "av.yaml": "world:\n  tick: 0.5\n  length: 30\n  road_end: 29\n  av: {model: external, command: [sh, av.sh], speed_mps: 9}\n"
               "behaviours: [walker.asl]\n",
    "av.sh": "touch started; while read -r x; do echo '{\"acceleration\":-1}'; done\n",
    "roads.yaml": "sut: {kind: lane-keeping, controller: paper-rate}\nfitness: {measure: max_oob, fails_at: 0.95}\n"
                  "budget: {tests: 3, virtual_s: 0}\ngenerators: [random]\nrepetitions: 1\n",
    "sql.py": "import sqlite3, sys\nstore = sqlite3.connect('s.gpkg')\nstore.executescript(sys.argv[1])\nstore.commit()\n",
}
MAKE = "jaywalk compare s.yaml --tests 2 --agents 1,2 --threads 1 --quiet --no-check --metrics --store-level all --store s.gpkg || exit 99; "


OWN = ("jaywalk compare av.yaml --tests 1 --agents 1 --no-check --quiet --store-level summary --store o.gpkg || exit 99; ")


def store(name, change, command, code, says, **more):
    """`change`: a command of the shell."""
    return Row(name, MAKE + change + "; jaywalk " + command, code, says, FILES, **more)


def sql(name, statements, command, code=2, says="s.gpkg", **more):
    return store(name, f'python3 sql.py "{statements}"', command, code, says, **more)


# Tests that met the precondition, so that pages name them.
FOUND = "jaywalk compare scenarios/paper.yaml --behaviours proximity --tests 2 --agents 9 --threads 1 --quiet --store-level all --store s.gpkg || exit 99; "


def renamed(what, name, *columns):
    """The name, an expression of SQL, stands in all of these columns, and no file is written beside `out`."""
    changes = ";".join(f"UPDATE {column.split('.')[0]} SET {column.split('.')[1]}={name}" for column in columns)
    return [Row(f"{what} for {command}", FOUND + f'python3 sql.py "{changes}"; jaywalk {command}; code=$?; '
                "ls -A | grep -vxE 'out|out-replays|s.gpkg|walker.asl|.*.yaml|av.sh|sql.py' && echo OUTSIDE; exit $code", 2, "which is no name", FILES, never="OUTSIDE")
            for command in ("export s.gpkg --all --out out", "export s.gpkg --all --format json --out out", "report s.gpkg --replays --html out")]


LINKED = ("mkdir -p out; {command} || exit 99; for f in {files}; do rm $f; ln -s $PWD/victim $f; done; echo mine >victim; "
          "{command} || exit 98; grep -x mine victim || exit 97")

ROWS = [
    *renamed("a behaviour whose name leads out", "'../x'", "behaviours.name", "tests.behaviour"),
    *renamed("a behaviour whose name begins at the root", "'/tmp/jaywalk-hostile'", "behaviours.name", "tests.behaviour"),
    *renamed("a behaviour whose name has a NUL", "'../x'||char(0)", "behaviours.name", "tests.behaviour"),
    *renamed("a behaviour whose name has an escape", "char(27)||'[2J'", "behaviours.name", "tests.behaviour"),
    *renamed("a behaviour whose name is a formula", "'=HYPERLINK(1)'", "behaviours.name", "tests.behaviour"),
    *renamed("an actor whose name has a NUL", "'p'||char(0)", "actors.name"),
    *renamed("an actor whose name is a formula", "'=1+1'", "actors.name"),
    *renamed("an event whose kind has an escape", "char(27)||'[2J'", "events.kind"),
    *renamed("an end that is a formula", "'@SUM(1)'", "tests.ended_by"),
    *renamed("a vehicle whose name is a formula", "'+1'", "vehicles.name", "tests.vehicle"),
    sql("a verdict whose name is a formula", "UPDATE assessments SET name='=1'", "report s.gpkg", says="which is no name"),
    *(Row(f"links in the place of what {command.split()[1]} writes", FOUND + LINKED.format(command=command, files=files), 0, "mine", FILES)
      for command, files in (("jaywalk export s.gpkg --all --out out", "out/*"), ("jaywalk export s.gpkg --all --format csv --out out", "out/*"),
                             ("jaywalk report s.gpkg --replays", "s-replays/* s.html"))),
    Row("a link in the place of the folder of replays", FOUND + "mkdir other; ln -s other s-replays; jaywalk report s.gpkg --replays; code=$?; ls other | grep . && exit 99; exit $code",
        2, "it is a link", FILES),
    store("a sound store", ":", "report s.gpkg", 0, ""),
    Row("a store that there is not", ["report", "none.gpkg"], 2, "none.gpkg"),
    Row("an empty file", ["report", "s.gpkg"], 2, "s.gpkg", {"s.gpkg": ""}),
    Row("a text", ["report", "s.gpkg"], 2, "s.gpkg", {"s.gpkg": "SQLite format 3\n" * 1000}),
    Row("a database without tables", "python3 sql.py 'CREATE TABLE a(b)'; jaywalk report s.gpkg", 2, "s.gpkg", FILES),
    store("half a store", "head -c 30000 s.gpkg >h; mv h s.gpkg", "report s.gpkg", 2, "s.gpkg"),
    store("a store without its first page", "dd if=/dev/zero of=s.gpkg bs=4096 count=1 conv=notrunc 2>/dev/null", "replay s.gpkg", 2, "s.gpkg"),
    store("a store whose pages are noise", "dd if=/dev/urandom of=s.gpkg bs=4096 seek=3 count=8 conv=notrunc 2>/dev/null", "judge s.gpkg", 2, "s.gpkg"),
    sql("a store without tests", "DROP TABLE tests", "report s.gpkg"),
    sql("a store without a column", "DROP VIEW results; ALTER TABLE tests DROP COLUMN ticks", "report s.gpkg"),
    sql("another program's database", "PRAGMA application_id=7", "report s.gpkg"),
    sql("a store of a later version", "UPDATE versions SET version='999'", "report s.gpkg"),
    sql("a verdict that there is not", "UPDATE assessments SET verdict='maybe'", "report s.gpkg"),
    store("no such test", ":", "replay s.gpkg --test 99", 2, "no such test"),
    store("no such behaviour", ":", "replay s.gpkg --behaviour nobody", 2, "no such test"),
    store("a store merged with itself", ":", "merge all.gpkg s.gpkg s.gpkg --quiet", 0, ""),
    store("a store merged over itself", ":", "merge s.gpkg s.gpkg", 2, "s.gpkg"),
    store("a store of another experiment resumed", ":", "compare s.yaml --tests 3 --agents 1 --seed 9 --store s.gpkg --resume", 2, "s.gpkg"),
    store("a store that is there already", ":", "compare s.yaml --tests 1 --agents 1 --store s.gpkg", 2, "s.gpkg"),
    store("a store of tests for a search", ":", "search roads.yaml --store s.gpkg --resume", 2, "s.gpkg"),
    Row("a store of searches for replay", "jaywalk search roads.yaml --threads 1 --quiet --store r.gpkg; jaywalk replay r.gpkg", 2, "r.gpkg", FILES),
    sql("a store with a column of another name", "ALTER TABLE actors RENAME COLUMN kind TO sort", "replay s.gpkg --test 0"),
    sql("a view for a table", "ALTER TABLE tests RENAME TO t; CREATE VIEW tests AS SELECT * FROM t", "report s.gpkg"),
    sql("a view without end", "ALTER TABLE tests RENAME TO t; CREATE VIEW tests AS WITH RECURSIVE n(i) AS"
        " (SELECT 1 UNION ALL SELECT i+1 FROM n) SELECT t.* FROM t,n", "report s.gpkg"),
    sql("a trigger", "CREATE TRIGGER x AFTER INSERT ON assessments BEGIN INSERT INTO assessments SELECT NULL,test_id,"
        "name||'x',verdict,value,tick,actor,robustness FROM assessments; END", "judge s.gpkg --metrics --write"),
    sql("a scenario with another text", "UPDATE inputs SET text=text||'# x' WHERE path LIKE '%.yaml'", "replay s.gpkg --test 0"),
    sql("a program with another text", "UPDATE inputs SET text=text||'// x' WHERE path LIKE '%.asl'", "replay s.gpkg --test 0"),
    sql("a test of 2,000,000,000 agents", "UPDATE tests SET agents=2000000000", "replay s.gpkg --test 0"),
    sql("verdicts of tests that there are not", "UPDATE assessments SET test_id=999999", "report s.gpkg"),
    sql("verdicts of no test", "UPDATE assessments SET test_id=zeroblob(9)", "report s.gpkg"),
    sql("a store without inputs", "DELETE FROM inputs", "replay s.gpkg --test 1", 2, "no copy of this file was kept"),
    sql("a test of a behaviour that there is not", "UPDATE tests SET behaviour='nobody'", "judge s.gpkg"),
    sql("a witness beyond all numbers", "UPDATE assessments SET actor=2147483648,verdict='fail'", "report s.gpkg"),
    sql("a witness who took no part", "UPDATE assessments SET actor=2147483647,verdict='fail'", "report s.gpkg", 0, "s.html"),
    sql("an actor of number 2147483647", "UPDATE actors SET actor=2147483647", "export s.gpkg --all --out out", says="an actor of test 1"),
    sql("a test without one of its actors", "DELETE FROM actors WHERE test_id=2 AND actor=1", "export s.gpkg --all --out out", says="the actors of test 2"),
    sql("an actor of negative length", "UPDATE actors SET length_m=-1", "export s.gpkg --all --out out", says="an actor of test 1"),
    sql("positions that are infinite", "UPDATE observations SET x=9e999", "export s.gpkg --all --out out", says="an infinite number"),
    sql("positions beyond the world", "UPDATE observations SET x=1e300,y=-1e300,speed=1e300", "export s.gpkg --all --out out", 0, "", most=100_000),
    sql("a scene without the AV", "DELETE FROM observations WHERE tick=1 AND actor=0", "judge s.gpkg", says="the observations of test 1"),
    sql("a test without observations", "DELETE FROM observations", "judge s.gpkg --metrics", says="the observations of test 1"),
    sql("ticks beyond all numbers", "UPDATE tests SET ticks=2147483648", "report s.gpkg", says="out of range"),
    sql("a store of negative scenes", "UPDATE tests SET scenes=-1", "export s.gpkg --all --out out", says="out of range"),
    sql("a test that came out otherwise", "UPDATE tests SET score=score+1", "replay s.gpkg --test 1", says="came out otherwise than stored"),
    Row("a stranger's store whose AV is a program", OWN + "rm started; jaywalk replay o.gpkg --test 0; code=$?; [ -e started ] && echo RAN; exit $code",
        2, "--allow-commands", FILES, never="RAN"),
    *(Row(f"a stranger's store for {command}", OWN + f"rm started; jaywalk {command} o.gpkg {more}; code=$?; [ -e started ] && echo RAN; exit $code",
          2, "--allow-commands", FILES, never="RAN")
      for command, more in (("explain", "--test 0"), ("judge", "--metrics"), ("export", "--all --out out"), ("coverage", "--coverage c.html"))),
    Row("one's own store whose AV is a program", OWN + "jaywalk replay o.gpkg --test 0 --html page.html --allow-commands", 0, "", FILES),
]
