"""Where commands read from and write to: full places, files that take each other's place, pipes, devices and links that
lead round, streams that are closed, limits of the system."""

import os

from row import WALKER, Row

AV = ("world:\n  tick: 0.5\n  length: 30\n  road_end: 29\n  av: {model: external, command: [sh, av.sh], speed_mps: 9}\n"
      "behaviours: [walker.asl]\n")
FILES = {
    "walker.asl": WALKER,
    "s.yaml": "behaviours: [walker.asl]\n",
    "av.yaml": AV,
    "av.sh": "while read -r x; do echo '{\"acceleration\":-1}'; done\n",
    "a.asl": "!go. +!go <- .print(done).\n",
    "p.mas2j": "MAS m { agents: a; }\n",
    "roads.yaml": "sut: {kind: lane-keeping, controller: paper-rate}\nfitness: {measure: max_oob, fails_at: 0.95}\n"
                  "budget: {tests: 3, virtual_s: 0}\ngenerators: [random]\nrepetitions: 1\n",
}
COMPARE = "jaywalk compare s.yaml --tests 40 --agents 2 --no-check --quiet --threads 2 "
STORE = COMPARE + "--store s.gpkg --store-level all || exit 99; "
LEFT = "; code=$?; ls -A | grep -E 'part|^out' && exit 99; exit $code"  # nothing half-written may stay
ENDINGS = "'' .asl .yaml .mas2j .gpkg .csv .json"
READERS = ("run f", "run f.asl", "run f.yaml", "run f.mas2j", "check f.asl", "fmt f.asl", "test f.asl", "repl f.asl", "search f.yaml",
           "learn f.yaml --policy o", "reach f.yaml", "report f.gpkg", "replay f.gpkg", "explain f.gpkg", "coverage f.gpkg",
           "export f.gpkg", "judge f.gpkg --metrics", "judge --trace f.csv --metrics", "merge out.gpkg f.gpkg",
           "run s.yaml --policy f.json", "run s.yaml --assertions f.yaml", "compare s.yaml --tests 1 --store f.gpkg --resume")


def shell(name, words, code, says="", **more):
    return Row(name, words, code, says, FILES, most=100_000, **more)


# root can read files without any permissions.
UNREADABLE = [shell("files that nobody may read", "umask 777; " + COMPARE + "--store s.gpkg --csv o.csv --report r.html",
                    *((0,) if os.geteuid() == 0 else (2, "s.gpkg: error: cannot be read: Permission denied")))]


def instead(name, make, why=""):
    """Each command is given something else for its file: `make` makes it of the name in $f."""
    return [shell(f"{name} for {command}", f"for e in {ENDINGS}; do f=f$e; {make}; done; timeout 30 jaywalk {command}", 2, why, seconds=30)
            for command in READERS]


ROWS = [
    shell("a store beyond the limit of sizes", "ulimit -f 20; " + COMPARE + "--store out.gpkg --store-level all" + LEFT, 2, "out.gpkg: error: cannot be written"),
    shell("a merge beyond the limit of sizes", STORE + "ulimit -f 20; jaywalk merge out.gpkg s.gpkg" + LEFT, 2, "out.gpkg: error: cannot be written"),
    shell("a table beyond the limit of sizes", "ulimit -f 1; " + COMPARE + "--per-test out.csv" + LEFT, 1, "File too large"),
    shell("a page beyond the limit of sizes", "ulimit -f 1; " + COMPARE + "--report out.html" + LEFT, 1, "File too large"),
    shell("a page of a store beyond the limit of sizes", STORE + "ulimit -f 1; jaywalk report s.gpkg --html out.html" + LEFT, 1, "File too large"),
    shell("a resumed store beyond the limit of sizes stays sound",
          STORE + "cp s.gpkg k; ulimit -f 450; jaywalk compare s.yaml --tests 400 --agents 2 --no-check --quiet --store s.gpkg --resume; code=$?; "
          "jaywalk export s.gpkg --list >/dev/null || exit 99; exit $code", 1, "the tests written before are kept"),
    shell("a store where all is printed to a full device", COMPARE + "--store s.gpkg --csv - >/dev/full; code=$?; jaywalk judge s.gpkg --metrics >/dev/null || exit 99; exit $code",
          1, "No space left on device"),
    shell("two outputs with one name", COMPARE + "--csv out --json ./out" + LEFT, 2, "--json: error: would write over './out', which --csv writes"),
    shell("two outputs with one name by a link", "touch out; ln -s out link; " + COMPARE + "--csv out --json link; code=$?; [ -s out ] && exit 99; exit $code", 2, "would write over"),
    shell("a page in place of its store", STORE + "cp s.gpkg k; jaywalk report s.gpkg --html s.gpkg; code=$?; cmp s.gpkg k || exit 99; exit $code", 2, "which the command reads"),
    shell("a table in place of its scenario", COMPARE + "--csv s.yaml; code=$?; grep -q walker s.yaml || exit 99; exit $code", 2, "which the command reads"),
    shell("two outputs to a device", COMPARE + "--csv /dev/null --json /dev/null", 0),
    shell("four merges to one name",
          STORE + "for i in 1 2 3 4; do jaywalk merge m.gpkg s.gpkg --quiet 2>>said & done; wait; cat said; ls -A | grep part && exit 99; "
          "[ $(grep -c 'the file exists' said) = 3 ] && jaywalk judge m.gpkg --metrics >/dev/null", 0, "m.gpkg: error: the file exists"),
    shell("three at a time resume one store",
          STORE + "for i in 1 2 3; do jaywalk compare s.yaml --tests 80 --agents 2 --no-check --quiet --store s.gpkg --resume & done; wait; "
          "jaywalk compare s.yaml --tests 80 --agents 2 --no-check --quiet --store s.gpkg --resume --csv a.csv; "
          "jaywalk compare s.yaml --tests 80 --agents 2 --no-check --quiet --csv b.csv; "
          "grep -v _us_ a.csv | cut -d, -f1-19 >a; grep -v _us_ b.csv | cut -d, -f1-19 >b; cmp a b", 0),
    shell("a store that shrinks while it is read", STORE + "(while truncate -s -4096 s.gpkg 2>/dev/null && [ -s s.gpkg ]; do :; done) & jaywalk judge s.gpkg --metrics >/dev/null; code=$?; wait; [ $code -le 2 ]", 0),
    shell("a store that becomes noise while it is read",
          STORE + "(for i in 9 8 7 6 5 4 3 2 1 0; do dd if=/dev/urandom of=s.gpkg bs=16384 seek=$i count=1 conv=notrunc 2>/dev/null; done) & "
          "jaywalk report s.gpkg >/dev/null; code=$?; wait; [ $code -le 2 ]", 0),
    shell("programs that change while they are read",
          "(for i in 1 2 3 4 5 6 7 8 9; do head -c 30000 /dev/urandom >a.asl; done) & for i in 1 2 3 4 5 6; do jaywalk run a.asl >/dev/null 2>&1; [ $? -le 2 ] || exit 99; done; wait", 0),
    shell("all streams closed", COMPARE + "--store s.gpkg <&- >&- 2>&- || exit 99; jaywalk judge s.gpkg --metrics >/dev/null", 0),
    shell("all streams closed, and a controller", "jaywalk run av.yaml --agents 1 --no-check --store s.gpkg <&- >&- 2>&-; jaywalk judge s.gpkg --metrics >/dev/null", 0),
    *(shell(f"eight open files for {command}", f"ulimit -n 8; jaywalk {command}; [ $? -le 2 ]", 0)
      for command in ("run p.mas2j", "run av.yaml --agents 1 --no-check", "search roads.yaml --quiet --store r.gpkg", "check .", "list behaviours",
                      "compare s.yaml --tests 4 --agents 1 --no-check --store t.gpkg --csv t.csv")),
    *(shell(f"a reader that ignores SIGPIPE for {command}", f"trap '' PIPE; (jaywalk {command}; echo $? >code) | true; case $(cat code) in 0|1|141) ;; *) exit 99;; esac", 0)
      for command in ("run a.asl", "help", "compare s.yaml --tests 4 --agents 1 --no-check", "list behaviours")),
    *UNREADABLE,
    shell("no home", "unset HOME XDG_STATE_HOME; echo '?- .print(still).' | jaywalk repl", 0, "still"),
    shell("no folder for temporary files", "export TMPDIR=/none; " + COMPARE + "--store s.gpkg --csv o.csv --report r.html && jaywalk merge m.gpkg s.gpkg --quiet", 0),
    shell("a working folder that is gone", "F=$PWD; mkdir gone; cd gone; rmdir ../gone; jaywalk run $F/a.asl || exit 99; jaywalk compare $F/s.yaml --tests 1 --agents 1 --csv o.csv", 2, "cannot write 'o.csv'"),
    shell("time zones that there are not", "TZ=:/dev/zero jaywalk run a.asl && TZ=Nowhere/Else jaywalk run a.asl", 0, "done"),
    shell("names of files that are no text", "a=$(printf '\\377.asl'); b=$(printf 'a\\nb.asl'); cp a.asl \"$a\"; cp a.asl \"$b\"; jaywalk run \"$a\" && jaywalk run \"$b\" && jaywalk check .", 0,
          "5 files checked: 0 errors"),
    shell("an argument of a megabyte", "jaywalk run s.yaml --set \"a=$(head -c 100000 /dev/zero | tr '\\0' x)\"", 2, "bytes left out"),
    shell("a policy with a number beyond doubles", "echo '{\"jaywalk_policy\": 1e999}' >p; jaywalk run s.yaml --policy p", 2, "p: error: the policy has a number that is too large"),
    shell("a policy of 200,000 brackets", "(head -c 200000 /dev/zero | tr '\\0' '['; head -c 200000 /dev/zero | tr '\\0' ']') >p; jaywalk run s.yaml --policy p", 2, "p: error: this is no policy"),
    *instead("a link to itself", "ln -s $f $f"),
    *instead("a pipe without a writer", "mkfifo $f"),
    *instead("bytes without end", "ln -s /dev/zero $f"),
    *instead("a folder", "mkdir $f"),
]
