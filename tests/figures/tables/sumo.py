"""The figures of tests that SUMO's vehicles drive in: docs/reference/vehicles.md."""
import re

DOCUMENT = "docs/reference/vehicles.md"


def ranking_of_models(documents, runs):
    text = runs.compare("simulators/sumo", "--tests", "100", "--threads", "2")
    text = text[text.index("AV models"):]
    ranked = re.findall(r"^\d+\. (\S+) +" + r"(\S+) *" * 6 + "$", text, re.MULTILINE)
    documents.table(DOCUMENT, "avs", ["AV model", "tests", "accuracy %", "collisions %", "avoidable %", "unavoidable %", "mean impact, m/s"],
                    [[f"`{row[0]}`", *row[1:]] for row in ranked])
    of = {}
    for name, agents, rows in re.findall(r"^(\S+) \((\d+)\)\n((?:  .*\n)+)", text, re.MULTILINE):
        of[name, agents] = {words[0]: words[1:] for words in map(str.split, rows.splitlines())}
    models = ("constant", "Krauss", "IDM", "ACC")
    cell = lambda found: f"{float(found[1]):.0f}, {float(found[2]):.0f}"  # noqa: E731
    documents.table(DOCUMENT, "avs-3", ["behaviour", *(f"`{model}`" for model in models)],
                    [[f"`{name}`", *(cell(found[model]) for model in models)] for (name, agents), found in of.items() if agents == "3"])
    one = {name: [f"{float(of[name, '1'][model][1]):.0f}" for model in ("constant", "Krauss")] for name in ("intersect", "proximity")}
    documents.says(DOCUMENT, f"with one pedestrian the accuracy of `intersect` falls from {one['intersect'][0]} % to {one['intersect'][1]} %, that "
                             f"of `proximity` from {one['proximity'][0]} % to {one['proximity'][1]} %")


def the_papers_av(documents, runs):
    common = ("compare", "scenarios/paper.yaml", "--tests", "50", "--agents", "1,3,10", "--threads", "2", "--quiet", "--no-check")
    own = runs.csv("--per-test", *common)
    sumo = runs.csv("--per-test", *common, "--set", "world.simulator={name: sumo, model: constant}")
    ends = ("behaviour", "agents", "test", "ended_by", "ticks", "precondition_ticks")
    others = sum(any(one[key] != two[key] for key in ends) for one, two in zip(own, sumo, strict=True))
    touched = sum(one["collision"] < two["collision"] for one, two in zip(own, sumo))
    missed = sum(one["collision"] > two["collision"] for one, two in zip(own, sumo))
    documents.says(DOCUMENT, f"Of {len(own):,} tests {others or 'none'} differs in behaviour, end, ticks or tick of the precondition")
    documents.says(DOCUMENT, f"in {touched:,} of them SUMO's AV touches somebody whom the world's does not, in {missed or 'none'} the other way")


CHECKS = (ranking_of_models, the_papers_av)
