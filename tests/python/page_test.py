# SPDX-License-Identifier: Apache-2.0
"""page_test.py PAGE: the lines after >>> in a page of the documents print what the page says (UPDATE_GOLDEN=1 writes
into the page what they print)."""
import contextlib
import doctest
import io
import os
import re
import sys
import tempfile
import traceback


def printed(example, names):
    """What the interpreter prints of an example, a line of an exception as doctest has it."""
    out = io.StringIO()
    with contextlib.redirect_stdout(out):
        try:
            exec(compile(example.source, "<page>", "single"), names)
        except Exception as error:
            print("Traceback (most recent call last):")
            print("    ...")
            print("".join(traceback.format_exception_only(type(error), error)), end="")
    return out.getvalue()


def updated(page):
    lines = page.split("\n")
    names = {"__name__": "__main__"}
    moved = 0
    for example in doctest.DocTestParser().get_examples(page):
        begin = example.lineno + example.source.count("\n") + moved
        old = example.want.count("\n")
        indent = " " * example.indent
        new = [(indent + line) if line else indent + "<BLANKLINE>" for line in printed(example, names).splitlines()]
        lines[begin:begin + old] = new
        moved += len(new) - old
    return "\n".join(lines)


def main():
    path = os.path.abspath(sys.argv[1])
    with open(path, encoding="utf-8") as file:
        page = file.read()
    if "to_dataframe" in page:
        try:
            import pandas  # noqa: F401
        except ImportError:
            print("skipped: there is no pandas")
            sys.exit(77)
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        if os.environ.get("UPDATE_GOLDEN") == "1":
            with open(path, "w", encoding="utf-8") as file:
                file.write(updated(page))
            return
        failed, tried = doctest.testfile(path, module_relative=False, optionflags=doctest.ELLIPSIS)
    print(f"{tried} examples, {failed} failed")
    sys.exit(1 if failed or not tried else 0)


main()
