#!/usr/bin/env python3
"""signalled.py CPU_SECONDS SIGNAL COMMAND... - sends a running command a signal.

Waits until the command has had so much CPU time, then sends the signal (INT, TERM, KILL ...).
Prints its exit code (negative: the signal that it died of) and how many milliseconds of CPU time it
took after the signal: what else a machine is busy with does not count. A command that ends before
gets no signal: it prints `ended`.
"""

import os
import signal
import subprocess
import sys
import time


def cpu_s(pid):
    """Of a process that is running; None once it has ended."""
    with open(f"/proc/{pid}/stat") as file:
        fields = file.read().rpartition(")")[2].split()
    if fields[0] == "Z":
        return None
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


def main():
    wanted, name, command = float(sys.argv[1]), sys.argv[2], sys.argv[3:]
    # A job in the background of a shell ignores SIGINT, and so would its children.
    process = subprocess.Popen(
        command, preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL))
    used = 0
    while used is not None and used < wanted:
        time.sleep(0.005)
        used = cpu_s(process.pid)
    if used is not None:
        os.kill(process.pid, getattr(signal, "SIG" + name))
    _, status, usage = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    if used is None:
        print("ended", process.returncode)
        return
    after = usage.ru_utime + usage.ru_stime - used
    print(process.returncode, round(1000 * after))


if __name__ == "__main__":
    main()
