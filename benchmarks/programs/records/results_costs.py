#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""results_costs.py FDEBENCH [RUNS | FILE]...: what reading large results files costs, as a table for docs/results.md.

For each number of runs (by default 10000 and 100000) a file is made by many_runs.py. What reads a file is run once: `report`,
`compare` with itself, `choose`, `run` (what it does before the first solve of a file that it continues), `merge` and `export`. The
seconds are those of the processor, the memory is the largest resident set.
"""

import os
import subprocess
import sys
import tempfile
from pathlib import Path

from many_runs import SCENES, measured, write_copies


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
            one = SCENES[0]
            commands = {
                "report": [file, "--out", f"{out}.report"],
                "compare": [file, file],
                "choose": [one, "--error", 1e-4, "--results", file],
                "run": ["--dry-run", "--scene", one, "--scheme", "l1", "--steps", 16, "--out", file],
                "merge": [file, "--out", f"{out}.merged"],
            } | {f"export --to {kind}": [file, "--out", f"{out}.{kind}"] for kind in ("csv", "flat", "sqlite")}
            for name, arguments in commands.items():
                seconds, memory = cost(program, *name.split(), *arguments)
                print(f"| {runs} | {file.stat().st_size / 1e6:.0f} MB | `{name}` | {seconds:.1f} s | {memory / 1e6:.0f} MB |", flush=True)


if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit(__doc__.splitlines()[0])
    main(sys.argv[1], sys.argv[2:] or ["10000", "100000"])
