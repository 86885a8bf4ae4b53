"""The figures of docs/reference/search_figures.md and docs/reference/search_peers.md: the files of tests/figures/search_figures. Times and p-values are not compared."""
import csv
import statistics

from learning import effort_rows

DOCUMENT = "docs/reference/search_figures.md"
PEERS = "docs/reference/search_peers.md"
STRETCHES = {"distinct_1m": "distinct failing stretches, 1 m", "distinct_2m": "distinct failing stretches, 2 m"}
FAILURES = {"failures": "failing tests"} | STRETCHES | {"sparseness": "sparseness"}
ALL = {"tests": "executed tests", "failures": "failing tests", "distinct_half_m": "distinct failing stretches, 0.5 m"} | STRETCHES | {
    "distinct_4m": "distinct failing stretches, 4 m", "twins_pct": "failing tests with a twin within 1 m (%)", "sparseness": "sparseness",
    "fitness_last_80": "mean fitness, final 80 %", "fitness_last_20": "mean fitness, final 20 %", "diversity": "diversity",
    "unwrapped_diversity": "diversity, angles unwrapped", "invalid_pct": "invalid candidates (%)",
    "tests_to_failure": "tests to the first failure"}


def study(runs, name):
    """Generator to column to the mean and standard deviation of its repetitions; those without a value are left out."""
    runs.run("tests/figures/search_figures", runs.jaywalk, runs.scratch, name)
    with open(runs.scratch / f"{name}.csv", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    of = {}
    for generator in dict.fromkeys(row["generator"] for row in rows):
        own = [row for row in rows if row["generator"] == generator]
        values = {column: [float(row[column]) for row in own if row[column]] for column in own[0] if column != "generator"}
        of[generator] = {column: (statistics.fmean(found), statistics.stdev(found) if len(found) > 1 else 0)
                         for column, found in values.items() if found}
    return of


def spread(of, column):
    digits = 2 if column.startswith("fitness") else 1
    return f"{of[column][0]:.{digits}f} ({of[column][1]:.{digits}f})" if column in of else ""


def table(documents, document, name, of, columns, names=None):
    names = names or list(of)
    documents.table(document, name, ["", *names], [[text, *(spread(of[name], column) for name in names)] for column, text in columns.items()])


def lane_keeping(documents, runs):
    for profile in ("paper-rate", "beamng-calibrated"):
        table(documents, DOCUMENT, profile, study(runs, profile), ALL)
        table(documents, DOCUMENT, f"second-seed-{profile}", study(runs, f"second-seed-{profile}"), FAILURES)
    more = {seed: spread(study(runs, name)[generator], "failures") for seed, name, generator in (
        (5, "more-frenetic", "frenetic"), (77, "more-frenetic-77", "frenetic"), (2, "more-wogan", "wogan"))}
    documents.says(DOCUMENT, f"Frenetic {more[5]} in 100 (seed 5) and {more[77]} in 80 (seed 77), WOGAN {more[2]} in 60 (seed 2)")
    one = study(runs, "seed-1")
    documents.says(DOCUMENT, f"with seed 1, 20 repetitions gave {one['frenetic']['failures'][0]:.1f} and {one['wogan']['failures'][0]:.1f}.")


def cars_that_nothing_was_tuned_on(documents, runs):
    names = ("random-sequences", "frenetic", "graft", "prospect")
    rows = []
    for car, text in (("untuned-stanley", "`stanley`"), ("untuned-van", "`beamng-calibrated` in the van"),
                      ("untuned-stanley-van", "`stanley` in the van")):
        of = study(runs, car)
        rows += [[text if column == "failures" else "", words, *(spread(of[name], column) for name in names)]
                 for column, words in FAILURES.items()]
    documents.table(DOCUMENT, "untuned", ["", "", *names], rows)


def peers(documents, runs):
    executed = {"tests": "executed tests"} | FAILURES
    rows = []
    for profile in ("paper-rate", "beamng-calibrated"):
        table(documents, PEERS, f"peers-{profile}", study(runs, f"peers-{profile}"), executed)
        of = study(runs, f"second-seed-peers-{profile}")
        rows += [[words, *(spread(found, column) for found in of.values())] for column, words in (
            ("failures", f"`{profile}`: failing tests"), ("distinct_1m", "1 m"), ("distinct_2m", "2 m"), ("sparseness", "sparseness"))]
    documents.table(PEERS, "second-seed-peers", ["", *of], rows)
    table(documents, PEERS, "sparse", study(runs, "sparse"), FAILURES, ["ambiegen", "frenetic", "prospect-sparse"])


def pedestrians(documents, runs):
    of = study(runs, "pedestrians")
    rows = [[text, *(spread(found, column) for found in of.values())] for column, text in (
        ("tests_to_failure", "tests to the first failure"), ("failures_per_1000", "failing of 1,000 tests"),
        ("situation_bins", "situations met"), ("diversity", "diversity (m)"))]
    rows.append(["naturalness", *(f"{found['naturalness'][0]:.3f}" for found in of.values())])
    documents.table(DOCUMENT, "pedestrians", ["", *(name.replace("-", " ") for name in of)], rows)


def kills(runs, name):
    """Generator to its kills and to the defects that it kills."""
    runs.run("tests/figures/search_figures", runs.jaywalk, runs.scratch, name)
    of = {}
    with open(runs.scratch / f"{name}.csv", encoding="utf-8") as file:
        for row in csv.DictReader(file):
            count, defects, tests = of.get(row["behaviour"], (0, 0, 0))
            killed = int(row["kills"])
            of[row["behaviour"]] = count + killed, defects + (killed > 0), tests + int(row["tests"])
    return of


def how_tests_come_about(documents, runs):
    of = study(runs, "situations")
    policy = runs.scratch / "coverage.json"
    runs.command("learn", "scenarios/learning/coverage.yaml", "--seed", "10", "--policy", policy, "--quiet")
    learned = runs.csv("--csv", "search", "scenarios/search/coverage-search.yaml", "--quiet", "--set",
                       "generators=[{generator: random, name: learned, sut: {behaviour: learner_coverage, "
                       f"policy: '{policy}', starts: chance, parameters: {{}}}}}}]")
    of["learned"] = {column: (statistics.fmean(found), statistics.stdev(found)) for column in ("situation_bins", "situation_bins_100")
                     for found in [[float(row[column]) for row in learned]]}
    searched, manual, agents = kills(runs, "kills-searched"), kills(runs, "kills-manual"), effort_rows(runs)
    by = {"manual": (f"{manual['manual'][0]} of {manual['manual'][2]:,}", manual["manual"][1])}
    by |= {name: searched[found][:2] for name, found in (("constrained", "random"), ("wogan", "wogan"), ("graft", "graft"))}
    by |= {"random": agents["random", "", "102"], "agency": agents["hunter", "", "102"]}
    by["learned"] = [", ".join(map(str, both)) for both in zip(agents["10000", "20", "102"], agents["10000", "30", "102"])]

    def row(how, what, tests, name):
        exact = name in ("manual", "model-based")
        bins = [f"{of[name][column][0]:.1f}" if exact else spread(of[name], column) for column in ("situation_bins", "situation_bins_100")]
        return [how, what, tests, *bins, *by.get(name, ("", ""))]

    documents.table(DOCUMENT, "come-about", ["tests come about", "", "tests", "situations", "by 100 tests", "kills of 1,180 tests", "defects killed"], [
        row("manually", "29 walks (`scenarios/search/manual.csv`); for kills 18 scripts", "29", "manual"),
        row("at random", "`random_behaviour`", "1,000", "random"),
        row("constrained random", "scripts: start, when to be in the AV's path, a change of mind", "1,000", "constrained"),
        row("from a model", "walks of `jaywalk reach`", "55", "model-based"),
        row("searched: `map-elites`", "the same scripts", "1,000", "map-elites"),
        *(row(f"`{name}`", "", "1,000", name) for name in ("ga", "cma-es", "wogan", "ogan", "graft")),
        row("learned", "`learner_coverage`, its policy of 1,000 tests; for kills `learner_directed`", "1,000", "learned"),
        ["", "`learner_coverage` while it learns", "1,000", None, "", "", ""],
        row("agency-directed", "`coverage_directed`, told what is covered; for kills `hunter`", "1,000", "agency"),
        row("behaviours", "`proximity`", "1,000", "proximity"),
        row("", "`intersect`", "1,000", "intersect")])

    of = {name: spread(found, "situation_bins") for name, found in study(runs, "situations-braking").items()}
    documents.says(DOCUMENT, f"met {of['random']} situations with `random_behaviour`, {of['constrained']} with random scripts, {of['map-elites']} "
                             f"with `map-elites`, {of['ga']} with `ga`, {of['graft']} with `graft` and {of['hunter']} with `hunter`")


CHECKS = (pedestrians, how_tests_come_about, lane_keeping, cars_that_nothing_was_tuned_on, peers)
