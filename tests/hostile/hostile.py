#!/usr/bin/env python3
"""hostile.py JAYWALK CLASS: each row of rows/CLASS.py ends with the exit code and the message that it
has to, soon, without a signal, an internal error or more memory than it is given. `all` names every
class; with --learn what was printed is shown."""

import concurrent.futures
import importlib
import os
import pathlib
import resource
import subprocess
import sys
import tempfile
import threading
import time

HERE = pathlib.Path(__file__).parent
sys.path.insert(0, str(HERE))
MEMORY = 4 << 30
SANITIZED_PATIENCE = 6
CLOCK_SECONDS = 120  # however little of the machine is left for us


def classes():
    return sorted(path.stem for path in (HERE / "rows").glob("*.py"))


def write(folder, files):
    for name, content in files.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(content if isinstance(content, bytes) else content.encode())


def feed(pipe, content):
    try:
        pipe.write(content)
        pipe.close()
    except BrokenPipeError:
        pass  # it has ended without reading


class Runner:
    def __init__(self, jaywalk):
        self.jaywalk = os.path.abspath(jaywalk)
        # Sanitizers reserve terabytes of addresses and take their time.
        self.took = {}  # seconds, by names
        self.sanitized = b"__asan_init" in pathlib.Path(jaywalk).read_bytes()

    def limit(self, seconds):
        if not self.sanitized:
            resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
        resource.setrlimit(resource.RLIMIT_CPU, (seconds, seconds))
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))

    def end_of(self, row, folder):
        """The exit code (None: it had to be killed), what was printed, and the most memory held, in MB."""
        write(folder, row.files)
        words = ["sh", "-c", row.words] if isinstance(row.words, str) else [self.jaywalk, *row.words]
        environment = dict(os.environ, NO_COLOR="1", HOME=str(folder), XDG_STATE_HOME=str(folder),
                           PATH=os.path.dirname(self.jaywalk) + ":" + os.environ["PATH"])
        stdin = row.stdin if isinstance(row.stdin, bytes) else row.stdin.encode()
        patience = SANITIZED_PATIENCE if self.sanitized else 1
        seconds = row.seconds * patience
        process = subprocess.Popen(words, cwd=folder, env=environment, stdin=subprocess.PIPE,
                                   stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                                   preexec_fn=lambda: self.limit(seconds),
                                   start_new_session=True)
        killed = threading.Event()
        clock = threading.Timer(CLOCK_SECONDS * patience, lambda: (killed.set(), os.killpg(process.pid, 9)))
        feeder = threading.Thread(target=feed, args=(process.stdin, stdin))
        clock.start()
        feeder.start()
        printed = process.stdout.read().decode(errors="replace")
        feeder.join()
        _, status, usage = os.wait4(process.pid, 0)
        clock.cancel()
        process.returncode = os.waitstatus_to_exitcode(status)
        return None if killed.is_set() else process.returncode, printed, usage.ru_maxrss / 1024

    def complaint(self, row):
        """What is wrong with how the row ended, and what was printed."""
        began = time.monotonic()
        with tempfile.TemporaryDirectory() as folder:
            code, printed, megabytes = self.end_of(row, pathlib.Path(folder))
        self.took[row.name] = time.monotonic() - began
        if code is None:
            return f"no end after {CLOCK_SECONDS} s", printed
        if code in (-9, -24, 137, 152):
            return f"more than {row.seconds} s of processor time", printed
        if code != row.code:
            return f"exit {code}, expected {row.code}", printed
        if row.most_mb and megabytes > row.most_mb and not self.sanitized:
            return f"held {megabytes:.0f} MB, more than {row.most_mb:.0f}", printed
        for piece in row.pieces():
            if piece not in printed:
                return f"does not say '{piece}'", printed
        if row.never and row.never in printed:
            return f"says '{row.never}'", printed
        if len(printed) > row.most:
            return f"prints {len(printed)} characters", printed
        return "", printed


def run_class(name, runner, learns):
    """How many rows it has, and how many of them failed. No class's texts are kept: a process counts as
    held what its parent held when it was started."""
    rows = importlib.import_module("rows." + name).ROWS
    del sys.modules["rows." + name]
    delattr(sys.modules["rows"], name)
    failed = 0
    with concurrent.futures.ThreadPoolExecutor(max(2, os.cpu_count() // 2)) as pool:
        for row, (complaint, printed) in zip(rows, pool.map(runner.complaint, rows)):
            if complaint or learns:
                print(f"{'FAILED' if complaint else 'ok'}: {row.name} ({runner.took[row.name]:.1f} s): {complaint}\n"
                      f"{printed[:600]}")
            failed += bool(complaint)
    return len(rows), failed


def main():
    jaywalk, wanted, *more = sys.argv[1:]
    runner = Runner(jaywalk)
    counts = [run_class(name, runner, "--learn" in more) for name in (classes() if wanted == "all" else [wanted])]
    failed = sum(count for _, count in counts)
    print(f"{sum(count for count, _ in counts)} rows, {failed} failed")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
