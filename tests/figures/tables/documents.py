"""Figures in documents: tables below a mark, and sentences that hold numbers."""
import difflib
import os
import pathlib
import re

# A number as documents write it, or none.
NUMBER = r"(?:-?\d+(?:,\d{3})*(?:\.\d+)?|none)"


class Documents:
    """Compares documents with what commands print; with UPDATE_GOLDEN=1 writes that into them."""

    def __init__(self, project):
        self.project = pathlib.Path(project)
        self.updates = os.environ.get("UPDATE_GOLDEN") == "1"
        self.compared = 0
        self.wrong = 0

    def _compare(self, document, place, text, stands, wanted):
        self.compared += 1
        if stands.group() == wanted:
            return
        if self.updates:
            (self.project / document).write_text(text[:stands.start()] + wanted + text[stands.end():])
            return
        self.wrong += 1
        print(f"{document}: {place} is stale")
        print("\n".join(difflib.unified_diff(stands.group().splitlines(), wanted.splitlines(), "document", "command", "", "", 0, "")))

    def _find(self, document, pattern, place):
        text = (self.project / document).read_text(encoding="utf-8")
        found = list(re.finditer(pattern, text))
        if len(found) != 1:
            self.wrong += 1
            print(f"{document}: {len(found)} places for {place}, expected one")
            return text, None
        return text, found[0]

    def table(self, document, name, head, rows):
        """The table below `<!-- figures: NAME -->`. A cell that is None is not compared (a time, say)."""
        text, stands = self._find(document, rf"(?<=<!-- figures: {name} -->\n)(\|.*\n)+", f"the table {name}")
        if stands is None:
            return
        old = [[cell.strip() for cell in line[1:-1].split("|")] for line in stands.group().splitlines()[2:]]
        for at, row in enumerate(rows):
            kept = old[at] if at < len(old) and len(old[at]) == len(row) else [""] * len(row)
            row[:] = [kept[i] if cell is None else str(cell) for i, cell in enumerate(row)]
        lines = ["| " + " | ".join(head) + " |", "|---" * len(head) + "|", *("| " + " | ".join(row) + " |" for row in rows)]
        self._compare(document, f"the table {name}", text, stands, "".join(re.sub(r"\|  +(?=\|)", "| ", line) + "\n" for line in lines))

    def says(self, document, sentence):
        """The one place that says this sentence with these or other numbers."""
        words = re.split(rf"({NUMBER})", sentence)
        pattern = "".join(NUMBER if at % 2 else re.sub(r"(\\ )+|\s+", r"\\s+", re.escape(word)) for at, word in enumerate(words))
        text, stands = self._find(document, pattern, f"'{sentence}'")
        if stands is None:
            return
        numbers = iter(words[1::2])
        self._compare(document, "a sentence", text, stands, re.sub(NUMBER, lambda _: next(numbers), stands.group()))


def counted(number):
    """1,234; none for 0."""
    return f"{number:,}" if number else "none"


def listed(names):
    """`a`, `b` and `c`."""
    quoted = [f"`{name}`" for name in names]
    return " and ".join(filter(None, [", ".join(quoted[:-1]), quoted[-1]]))
