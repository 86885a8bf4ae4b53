"""The figures of docs/reference/learning_figures.md: what tests/figures/learning_figures prints. Its CPU times are not compared."""
import re

DOCUMENT = "docs/reference/learning_figures.md"


def printed(runs, table):
    return runs.run("tests/figures/learning_figures", runs.jaywalk, table).splitlines()


def accuracy(documents, runs):
    rows = []
    for line in printed(runs, "accuracy")[1:]:
        agents, name, learner, tests = line[:6].strip(), line[7:27].strip(), line[28:42].strip(), line[43:49].strip()
        mean, worst, score = line[50:58].strip(), line[59:67].strip(), line[68:76].strip()
        rows.append([agents, f"`{name}`", learner, f"{int(tests):,}" if tests else "", mean, worst, score, None if learner else ""])
    documents.table(DOCUMENT, "accuracy", ["pedestrians", "behaviour", "learner", "tests", "accuracy", "worst", "score", "CPU s"], rows)


def scores(documents, runs):
    names = {"the best possible": "the best possible", "proximity": "`proximity`", "intersect": "`intersect`"}
    rows, seeds = [], {}
    for line in printed(runs, "score")[2:]:
        name, numbers = line[:20].strip(), [float(word) for word in re.split(r" +", line[20:].strip())[-4:]]
        if name in names:
            rows.append([names[name], *(f"{number:.1f}" for number in numbers)])
        else:
            name, numbers = re.match(r"(\S+), seed \d+ +(.*)", line).groups()
            seeds.setdefault(name, []).append([float(word) for word in numbers.split()])
    for name, found in seeds.items():
        columns = list(zip(*found))
        rows.append([f"`learner`, {name}, 5,000 tests, mean of sixty seeds (worst)",
                     *(f"{sum(column) / len(column):.1f} ({min(column):.1f})" for column in columns)])
    documents.table(DOCUMENT, "scores", ["", "success, all tests", "score", "success where `proximity` succeeds", "score there"], rows)


def defects(documents, runs):
    rows = []
    for line in printed(runs, "defects")[1:]:
        name, numbers, of = line[:28].strip(), line[28:].split()[:-2], line.split()[-1]
        name = re.sub(r"^\w+", lambda word: f"`{word.group()}`", name)
        rows.append([name, *(f"{int(number):,}" for number in numbers)])
    documents.table(DOCUMENT, "defects", ["behaviour", "kills of 11,800 tests", "of these: defects of names met, 6,800 tests",
                                          "never met, 5,000 tests", "defects killed", f"never met, of {of}"], rows)


def effort_rows(runs):
    """(tests or behaviour, seed, seed of the tests) to kills and defects killed."""
    rows = {}
    for line in printed(runs, "effort")[1:]:
        words = line.split()
        key = tuple(words[:3]) if len(words) == 5 else (words[0], "", words[1])
        rows[key] = int(words[-2]), int(words[-1])
    return rows


def effort(documents, runs):
    of = {key: kills for key, (kills, _) in effort_rows(runs).items()}
    few, many = ([of[tests, seed, "103"] for seed in ("40", "41", "42")] for tests in ("3000", "10000"))
    documents.says(DOCUMENT, f"learned with seeds 40 to 42: {few[0]}, {few[1]} and {few[2]}; after 10,000 tests {many[0]}, {many[1]} and {many[2]}; "
                             f"`hunter` {of['hunter', '', '103']}")


def transfer(documents, runs):
    rows = []
    head, *lines = printed(runs, "transfer")
    for line in lines:
        name = {"hunter": "`hunter`, by hand", "random_behaviour": "`random_behaviour`"}.get(line[:20].strip(), line[:20].strip())
        rows.append([name, *line[20:].split()])
    documents.table(DOCUMENT, "transfer", ["learned with", *head[20:].split()], rows)


def coverage(documents, runs):
    of = {line.split()[0]: line.split()[-1] for line in printed(runs, "coverage")[1:]}
    documents.table(DOCUMENT, "coverage", ["how tests come about", "bins of 92"], [
        ["random (`random_behaviour`)", of["random_behaviour"]],
        ["agency-directed (`coverage_directed`, told what is covered)", of["coverage_directed"]],
        ["learned (`learner_coverage`, while it learns)", of["learner_coverage"]],
        ["model-based (`jaywalk reach`: 55 different walks)", None]])


CHECKS = (accuracy, scores, defects, effort, transfer, coverage)
