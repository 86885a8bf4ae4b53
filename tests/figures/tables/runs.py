"""Runs of the command, and what they print."""
import collections
import csv
import pathlib
import re
import subprocess

Kills = collections.namedtuple("Kills", "kills percent defects first_kill")


class Runs:
    def __init__(self, project, jaywalk, scratch):
        self.project = project
        self.jaywalk = jaywalk
        self.scratch = pathlib.Path(scratch)

    def run(self, *words):
        """What a program prints, started in the project's folder."""
        done = subprocess.run([str(word) for word in words], cwd=self.project, stdout=subprocess.PIPE, text=True)
        if done.returncode != 0:
            raise SystemExit(f"exit code {done.returncode} of: {' '.join(map(str, words))}")
        return done.stdout

    def command(self, *words):
        return self.run(self.jaywalk, *words)

    def compare(self, scenario, *words):
        return self.command("compare", f"scenarios/{scenario}.yaml", *words, "--no-check")

    def csv(self, option, *words):
        """The rows of a file that the command writes."""
        path = self.scratch / "rows.csv"
        path.unlink(missing_ok=True)
        self.command(*words, option, path)
        with open(path, encoding="utf-8") as file:
            return list(csv.DictReader(file))


def kills(text):
    """The printed table of kills: (behaviour, number of agents) to its row."""
    rows = {}
    for name, agents, count, percent, defects, beyond, first in re.findall(
            r"^(\S+) \((\d+)\) +(\d+) +([\d.]+) +(\d+) / *\d+ +(> )?([\d.]+) ", text, re.MULTILINE):
        rows[name, int(agents)] = Kills(int(count), float(percent), int(defects), beyond + first)
    if not rows:
        raise SystemExit(f"no table of kills:\n{text}")
    return rows
