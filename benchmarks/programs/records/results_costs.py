#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""results_costs.py FDEBENCH [RUNS | FILE]...: what reading large results files costs, as a table for docs/results.md.

For each number of runs (by default 5000 and 50000) a file is made by many_runs.py. `merge`, `compare` with itself,
`export` and `report` are run once; the seconds are those of the processor, the memory is the largest resident set.
"""

import os
import subprocess
import sys
import tempfile
from pathlib import Path

from many_runs import measured, write_copies


def cost(*words):
    """Processor seconds and bytes of memory of a command."""
    with subprocess.Popen(list(map(str, words)), stdout=subprocess.DEVNULL) as process:
        _, status, used = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode != 0:
        sys.exit(f"{words[1]} ends with exit code {process.returncode}")
    return used.ru_utime + used.ru_stime, used.ru_maxrss * 1024


def main(program, sizes):
    print("| runs | bytes | command | processor time | memory |\n|---|---|---|---|---|")
    base = None
    with tempfile.TemporaryDirectory() as folder:
        for size in sizes:
            file = Path(size)
            if size.isdecimal():
                base = base or measured(program)
                file = Path(folder) / f"{size}.jsonl"
                write_copies(base, int(size), file)
            with file.open() as lines:
                runs = sum('"ending":' in line for line in lines)
            out = Path(folder) / f"out-{size.replace('/', '-')}"
            for command in (["merge", file, "--out", f"{out}.merged"], ["compare", file, file],
                            ["export", file, "--to", "sqlite", "--out", f"{out}.sqlite"], ["export", file, "--to", "csv", "--out", f"{out}.csv"],
                            ["report", file, "--out", f"{out}.report"]):  # fmt: skip
                seconds, memory = cost(program, *command)
                name = " ".join(command[0:1] + command[2:4] * (command[0] == "export"))
                print(f"| {runs} | {file.stat().st_size / 1e6:.0f} MB | `{name}` | {seconds:.1f} s | {memory / 1e6:.0f} MB |", flush=True)


if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit(__doc__.splitlines()[0])
    main(sys.argv[1], sys.argv[2:] or ["5000", "50000"])
