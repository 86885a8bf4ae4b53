"""The figures of docs/reference/defect_figures.md."""
import collections
import csv
import re
import sqlite3

from documents import counted, listed
from runs import kills

DOCUMENT = "docs/reference/defect_figures.md"
SEARCH = ("search", "scenarios/search/defects-search.yaml")
HEALTHY = ("--set", "experiment.defects=[]")
SEEKERS = ("random_behaviour", "brink", "feint", "loiter", "shadow", "decoy_and_runner", "tail", "stall", "sprint", "crowd",
           "repeat", "hunter")


def kills_by_defect(runs, scenario, *words):
    """(behaviour, agents, defect with its severity) to kills."""
    rows = runs.csv("--kills", "compare", f"scenarios/{scenario}.yaml", *words, "--quiet", "--no-check")
    return {(row["behaviour"], int(row["agents"]), named(row)): int(row["kills"]) for row in rows}


def named(row):
    return f"{row['defect']}={row['severity']}" if row["severity"] else row["defect"]


def best_and_next(of, name):
    """Kills of a behaviour, and which others have most, with how many: "`feint` and `sprint`, 34"."""
    others = {other: count for other, count in of.items() if other != name}
    most = max(others.values())
    return of[name], f"{listed(other for other, count in others.items() if count == most)}, {most}"


def searches(documents, runs):
    file = runs.scratch / "searches.csv"
    found = kills(runs.command(*SEARCH, "--kills", file))
    names = ("random", "exhaustive", "wogan", "frenetic", "ogan", "graft")
    rows = [found[name, 1] for name in names]
    documents.table(DOCUMENT, "searches", ["", *names], [
        ["kills, % of the tests", *(f"{row.percent:.1f}" for row in rows)],
        ["defects killed", *(row.defects for row in rows)],
        ["first kill", *(row.first_kill for row in rows)]])

    text = runs.compare("defects", "--agents", "1", "--tests", "50", "--seed", "707", "--with-kills", file)
    of = {name: counted(row.kills) for (name, _), row in kills(text).items()}
    documents.says(DOCUMENT, f"these rows beside {of['intersect']} kills of `intersect`, {of['random_behaviour']} of `random_behaviour`, "
                             f"{of['hunter']} of `hunter`, {of['random_action']} of `random_action`, {of['proximity_15']} of "
                             f"`proximity_15` and {of['election']} of `election`")
    team = re.search(r"^smallest team that kills all that anybody kills: (.*)$", text, re.MULTILINE)[1]
    documents.says(DOCUMENT, f"the smallest team that kills all is {listed(re.findall('([^ ,]+) [(]', team))}.")
    rank = dict(re.findall(r"(\w+) (-?[\d.]+) \(17\)", text))
    documents.says(DOCUMENT, f"over the 17 behaviours: {rank['accuracy']} of accuracy, {rank['score']} of score.")


def scripts_of_one_change_of_mind(documents, runs):
    file = runs.scratch / "scripts.csv"
    text = runs.command(*SEARCH, "--generators", "exhaustive", "--set", "budget.tests=10000", "--kills", file)
    with open(file, encoding="utf-8") as lines:
        rows = list(csv.DictReader(lines))
    tests = max(int(row["tests"]) for row in rows)
    of = {named(row): int(row["kills"]) for row in rows if int(row["kills"])}
    least, most = min(of.values()), max(of.values())
    documents.says(DOCUMENT, f"runs all {tests:,} scripts of a space")
    documents.says(DOCUMENT, f"- {len(of)} of the {len(rows)} defects are killed, each by {100 * least / tests:.1f} to {100 * most / tests:.0f} % of "
                             f"the scripts ({least} for {listed(name for name in of if of[name] == least)}, "
                             f"{most:,} for {listed(name for name in of if of[name] == most)})")
    one, two = re.findall(r"^exhaustive: (\d+) of \d+ defects are killed by the ", text, re.MULTILINE)
    documents.says(DOCUMENT, f"**One script kills {one} of them, two kill {two}**")
    documents.says(DOCUMENT, f"- {len(rows) - len(of)} are killed by none.")

    groups = ("merged-group", "group-as-first", "nearest-only")
    of = kills_by_defect(runs, "defects", "--agents", "2,3", "--tests", "50", "--seed", "101", "--defects", ",".join(groups))
    by = {group: {(name, agents): count for (name, agents, defect), count in of.items() if defect.split("=")[0] == group} for group in groups}
    documents.says(DOCUMENT, f"it takes two to be merged | `crowd`, 3 pedestrians: {by['merged-group']['crowd', 3]} of 50 tests")
    documents.says(DOCUMENT, f"is seen as it is | `crowd`, 3 pedestrians: {by['group-as-first']['crowd', 3]} of 50")
    documents.says(DOCUMENT, f"always the nearest | `repeat`, 3 pedestrians: {by['nearest-only']['repeat', 3]} of 50")
    all_three = [name for name in SEEKERS if all(by[group][name, 2] for group in groups)]
    documents.says(DOCUMENT, f"With two pedestrians {listed(all_three)} kill the first three, too.")
    of = kills_by_defect(runs, "defects", "--agents", "1", "--tests", "50", "--seed", "101", "--defects", "fast-as-noise",
                         "--set", "world.pedestrians.speed_mps=3")
    documents.says(DOCUMENT, f"`sprint`, one pedestrian of up to 3 m/s: {of['sprint', 1, 'fast-as-noise=2.5']} of 50")


def failures(runs, seed, model, *words):
    """Avoidable failures of 200 tests, by behaviour."""
    rows = runs.csv("--per-test", "compare", "scenarios/defects.yaml", "--agents", "1", "--tests", "200", "--seed", seed, *HEALTHY,
                    "--set", f"world.av.model={model}", "--behaviours", "random_behaviour,hunter", "--quiet", "--no-check", *words)
    return collections.Counter(row["behaviour"] for row in rows if row["avoidability"] == "fail")


def starts_with_failures(runs, model, starts, *words):
    """Start cells of which some script gives an avoidable failure."""
    store = runs.scratch / f"{model}-{len(words)}.gpkg"
    runs.command(*SEARCH, "--generators", "exhaustive", "--set", "defects=[]", "--set", "sut.starts=given",
                 "--set", f"sut.parameters.world.spawn.cells=[{starts}]", "--set", f"sut.parameters.world.av.model=[{model}]",
                 *words, "--set", "fitness.measure=blamed", "--set", "fitness.harmless=0", "--set", "fitness.worst=1",
                 "--store", store, "--quiet")
    with sqlite3.connect(store) as tests:
        return tests.execute("SELECT count(DISTINCT json_extract(input, '$[#-1]')) FROM search_tests WHERE failed").fetchone()[0]


def start_cells(documents, runs):
    script = "sut.parameters.behaviours.scripted.parameters"
    starts = runs.scratch / "starts.csv"
    few = ("--set", "budget.tests=100000", "--set", f"{script}.pause=[1]", "--set", f"{script}.meanwhile=[back, stand]")
    models, of, cells = ("braking", "aeb", "idm"), {}, {}
    for model in models:
        of[model] = {seed: failures(runs, seed, model, *(("--starts", starts) if seed == 101 else ())) for seed in (101, 707, 808)}
        cells[model] = starts_with_failures(runs, model, starts, *few)
    head = ["", *(f"`{model}`" for model in models)]
    documents.table(DOCUMENT, "starts", head, [
        ["start cells of which some of 312 scripts gives an avoidable failure", *cells.values()],
        ["failures of `random_behaviour`, one test of each start cell", *(of[model][101]["random_behaviour"] for model in models)]])
    documents.table(DOCUMENT, "failures", ["avoidable failures in 200 tests", *head[1:]], [
        [text, *(", ".join(str(found[name]) for found in of[model].values()) for model in models)]
        for name, text in (("random_behaviour", "`random_behaviour`, seeds 101, 707, 808"), ("hunter", "`hunter`, the same seeds"))])
    many = starts_with_failures(runs, "braking", starts, "--set", "budget.tests=231872")
    documents.says(DOCUMENT, f"has {many} start cells after 231,872 of its 280,800 tests")
    documents.says(DOCUMENT, f"so five times those of `random_behaviour`, {5 * of['braking'][101]['random_behaviour']}, cannot be had out of "
                             f"200 tests, but nearly all of the {many} can.")
    times = sorted(found["hunter"] / found["random_behaviour"] for found in of["braking"].values())
    documents.says(DOCUMENT, f"with `braking` {times[0]:.1f} to {times[-1]:.1f} times, of a bound of {many} of 200 start cells with seed 101")


def behaviours(documents, runs):
    names = ("random_behaviour", "intersect", "proximity_25", "brink", "feint", "hunter")
    chosen = ("--behaviours", ",".join(names))
    of = {}
    for seed in (707, 808):
        of[seed] = {}
        for agents, tests in (("1", "50"), ("2,3", "30")):
            of[seed] |= kills(runs.compare("defects", "--agents", agents, "--tests", tests, "--seed", seed, *chosen))
    text = runs.compare("defects", "--agents", "1", "--tests", "50", "--seed", "707", *chosen, *HEALTHY, "--metrics")
    natural = re.findall(r"^  natural_steps +1 +50 +([\d.]+)", text, re.MULTILINE)
    documents.table(DOCUMENT, "behaviours", ["behaviour", "1", "2", "3", "1, seed 808", "2, seed 808", "3, seed 808", "natural steps"], [
        [f"`{name}`", *(f"{row.kills} ({row.defects})" for row in (of[seed][name, agents] for seed in of for agents in (1, 2, 3))),
         f"{float(steps):.2f}"] for name, steps in zip(names, natural, strict=True)])
    times = {seed: [f"{of[seed]['hunter', n].kills / of[seed]['random_behaviour', n].kills:.1f}" for n in (1, 2, 3)] for seed in of}
    documents.says(DOCUMENT, f"`hunter` has {times[707][0]}, {times[707][1]} and {times[707][2]} times the kills of `random_behaviour` with "
                             f"seed 707, {times[808][0]}, {times[808][1]} and {times[808][2]} times with seed 808, and with seed 707 "
                             f"a median first kill of {of[707]['hunter', 1].first_kill}.")


def whole_set(documents, runs):
    columns = {}
    for agents, seed in ((1, 2211), (1, 3311), (3, 2211)):
        file = runs.scratch / "kills.csv"
        found = kills(runs.compare("defects", "--agents", agents, "--tests", "200", "--seed", seed, "--kills", file))
        columns[f"{agents}, seed {seed}"] = found["hunter", agents], found["random_behaviour", agents]
        if (agents, seed) == (1, 2211):
            with open(file, encoding="utf-8") as lines:
                of = {row["behaviour"]: counted(int(row["kills"])) for row in csv.DictReader(lines) if row["defect"] == "blind-to-standing"}
            documents.says(DOCUMENT, f"`hunter` kills it in {of['hunter']} of 200 tests, `stall` in {of['stall']}, `brink` in {of['brink']}; "
                                     f"`random_behaviour` in {of['random_behaviour']}, `proximity_15` in {of['proximity_15']}, "
                                     f"`proximity_25` in {of['proximity_25']}, `election` in {of['election']}.")
    documents.table(DOCUMENT, "whole-set", ["", *columns], [
        ["kills of `hunter` and of `random_behaviour`", *(f"{one.kills} and {two.kills}" for one, two in columns.values())],
        ["times as many", *(f"{one.kills / two.kills:.1f}" for one, two in columns.values())],
        ["median first kill of the two", *(f"{one.first_kill} and {two.first_kill}" for one, two in columns.values())]])


# Behaviour, defect, what the table says of it, agents, other settings.
SPECIALISTS = (
    ("brink", "comfort-braking=2", "", 1),
    ("feint", "kerb-standing", "", 1),
    ("loiter", "lateral-bias", "", 1),
    ("shadow", "near-obstacle", ", where the AV comes from further away: `--set world.av.start=-40`", 1, "world.av.start=-40"),
    ("tail", "short-range=20", "", 1),
    ("stall", "gives-up=15", ": it drives on after 15 s", 1),
    ("sprint", "fast-as-noise", ", where people can run: `--set world.pedestrians.speed_mps=3`", 1, "world.pedestrians.speed_mps=3"),
    ("crowd", "group-as-first", ", two pedestrians", 2),
    ("repeat", "trusts-walkers", "", 1),
    ("hunter", "ignores-along", "", 1),
    ("decoy_and_runner", "nearest-only", ", two pedestrians, `--set world.av.start=-40`", 2, "world.av.start=-40"))


def kills_of_one(runs, defect, agents, tests, seed, *settings):
    """By behaviour."""
    sets = [word for setting in settings for word in ("--set", setting)]
    of = kills_by_defect(runs, "defects", "--agents", agents, "--tests", tests, "--seed", seed, "--behaviours", ",".join(SEEKERS),
                         "--set", f"experiment.defects=[{defect}]", *sets)
    return {name: count for (name, _, _), count in of.items()}


def specialists(documents, runs):
    rows = []
    for name, defect, text, agents, *settings in SPECIALISTS:
        own, others = best_and_next(kills_of_one(runs, defect, agents, 40, 0, *settings), name)
        rows.append([f"`{name}`", f"`{defect}`{text}", own, others])
    documents.table(DOCUMENT, "specialists", ["behaviour", "defect", "kills", "the next best"], rows)
    near = kills_of_one(runs, "near-obstacle=1", 1, 150, 0)
    nearest = kills_of_one(runs, "nearest-only", 2, 40, 0)
    documents.says(DOCUMENT, f"`decoy_and_runner` has {nearest['decoy_and_runner']} kills of `nearest-only` in 40 tests "
                             f"(`hunter` {nearest['hunter']}), `shadow` has {near['shadow']} of `near-obstacle=1` in 150 (`feint` {near['feint']})")
    comfort = [kills_of_one(runs, "comfort-braking=2", 1, 60, seed) for seed in (1, 808)]
    kerb = [kills_of_one(runs, "kerb-standing", 1, 60, seed) for seed in (1, 808)]
    documents.says(DOCUMENT, "With other seeds: " + "; ".join(
        f"of 60 tests of seed {seed}, `comfort-braking=2` is killed by {braking['brink']} of `brink`, {braking['hunter']} of `hunter` "
        f"and {braking['crowd']} of `crowd`, `kerb-standing` by {standing['feint']} of `feint`, {standing['hunter']} of `hunter` "
        f"and {standing['sprint']} of `sprint`" for seed, braking, standing in zip((1, 808), comfort, kerb)))


def brink_and_the_healthy_driver(documents, runs):
    common = ("compare", "scenarios/defects.yaml", "--agents", "1", "--seed", "909", "--behaviours", "brink", "--quiet", "--no-check")
    rows = runs.csv("--per-test", *common, "--tests", "10000", *HEALTHY)
    hit = sum(row["collision"] == "1" for row in rows)
    exercised = sum(row["avoidability"] != "vacuous" for row in rows)
    met = sum(row["precondition_ticks"] != "" for row in rows)
    documents.says(DOCUMENT, f"`brink` against the healthy driver: {counted(hit)} of 10,000 tests has a collision, {exercised:,} are exercised and "
                             f"{met:,} meet the precondition;")
    rows = [row for row in runs.csv("--per-test", *common, "--tests", "1000", "--defects", "latency=0.3") if row["vehicle"] == "latency=0.3"]
    failed = sum(row["avoidability"] == "fail" for row in rows)
    exercised = sum(row["avoidability"] != "vacuous" for row in rows)
    documents.says(DOCUMENT, f"with `latency=0.3`, {failed} of {exercised} exercised tests are avoidable failures ({100 * failed / exercised:.0f} %)")


def broken_drivers(documents, runs):
    listing = runs.run("python3", "scenarios/controllers/broken.py", "list")
    faults = [line.split()[0] for line in listing.splitlines() if line.split()[0] != "healthy"]
    columns = {"1": (1, 100, 707), "3": (3, 30, 707), "1, seed 808": (1, 100, 808), "3, seed 808": (3, 30, 808)}
    of = {column: {} for column in columns}
    for column, (agents, tests, seed) in columns.items():
        for fault in faults:
            found = kills_by_defect(runs, "broken", "--agents", agents, "--tests", tests, "--seed", seed,
                                    "--set", f"world.av.command=[python3, scenarios/controllers/broken.py, {fault}]")
            for name in ("hunter", "random_behaviour"):
                of[column][name, fault] = found[name, agents, "given"]
    total = {(name, column): sum(of[column][name, fault] for fault in faults) for name in ("hunter", "random_behaviour") for column in columns}
    documents.table(DOCUMENT, "broken", ["", *columns], [[f"`{name}`", *(total[name, column] for column in columns)]
                                                         for name in ("hunter", "random_behaviour")])
    times = [f"{total['hunter', column] / total['random_behaviour', column]:.1f}" for column in columns]
    documents.says(DOCUMENT, f"That is {times[0]}, {times[1]}, {times[2]} and {times[3]} times as many.")
    found = [sum(of[column]["hunter", fault] > 0 for fault in faults) for column in columns]
    documents.says(DOCUMENT, f"`hunter` kills {found[0]} of the {len(faults)} faults with one pedestrian and seed 707, {found[1]} with three, "
                             f"{found[2]} and {found[3]} with seed 808")
    busy = [of[column][name, "busy"] for name in ("hunter", "random_behaviour") for column in ("3", "3, seed 808")]
    documents.says(DOCUMENT, f"`busy` by chance only ({busy[0]} and {busy[1]} of 30, `random_behaviour` {busy[2]} and {busy[3]})")


CHECKS = (searches, scripts_of_one_change_of_mind, start_cells, behaviours, whole_set, specialists, brink_and_the_healthy_driver,
          broken_drivers)
