"""The figures of paper.md, situations.md and learning_figures.md in docs/reference that take seconds."""
import re

from documents import counted

PUBLISHED = "docs/reference/paper.md"
SITUATIONS = "docs/reference/situations.md"


def published_values(documents, runs):
    of = {}
    for preset in ("paper", "as-published-program"):
        text = runs.compare("paper", "--behaviours", "random_action,random_behaviour,proximity,election", "--preset", preset)
        of[preset] = int(re.search(r"^(\d+) of 144 published ", text, re.MULTILINE)[1])
    documents.says(PUBLISHED, f"explains (the 99.9 % interval of the difference of two runs): {counted(of['paper'])} from those of the first command, "
                             f"{counted(of['as-published-program'])} from those of the second.")


def situations_that_can_be_met(documents, runs):
    def reached(*words):
        text = runs.command("reach", "scenarios/search/coverage.yaml", *words, "--no-check")
        return re.search(r"^(\d+) of (\d+) bins can be met", text, re.MULTILINE).groups()

    met, bins = reached()
    documents.says("docs/reference/learning_figures.md", f"that {met} of the {bins} bins can be met at all")
    braking = ("--set", "world.length=40", "--set", "world.av.model=braking", "--most-states")
    documents.says(SITUATIONS, f"it has found {reached(*braking, 60000)[0]} of {bins} bins after 60,000 states, and {reached(*braking, 300000)[0]} after 300,000")


CHECKS = (published_values, situations_that_can_be_met)
