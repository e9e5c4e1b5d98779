#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What pages say that commands print is what they print: outputs.py FDEBENCH [PAGE]...

In the `console` blocks of README.md and docs/ a command follows "$ ", further lines of it follow "> ", and what comes after is its
output, where "..." stands for any lines. A block is run in a folder of its own; a page's blocks share it. Numbers are compared to
six digits, but not in lines with times, and of `choose`, whose answer depends on the machine, the first line up to the scheme. A
block that shows no output is not run. One line for each fault.
"""

import functools
import os
import re
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
BLOCK = re.compile(r"^```console\n(.*?)^```$", re.MULTILINE | re.DOTALL)
NUMBER = re.compile(r"(?<![\w.])-?\d[\d.]*(?:e[+-]?\d+)?")
TIMES = re.compile(r"\d (?:µs|ms|s)\b")
ELSEWHERE = {"extending.md", "library.md"}  # tests/extending and tests/outside run these
REST = ["..."]  # any lines


def commands(block):
    """(command, lines of its output) of each command of a block."""
    found = []
    for line in block.splitlines():
        if line.startswith("$ "):
            found.append((line[2:], []))
        elif line.startswith("> ") and found and not found[-1][1]:
            found[-1] = (f"{found[-1][0]}\n{line[2:]}", [])
        elif found:
            found[-1][1].append(line)
    return found


def same_line(shown, printed):
    """Equal but for numbers, which agree to six digits; of lines with times the words alone."""
    if NUMBER.sub("#", shown) != NUMBER.sub("#", printed):
        return False
    if TIMES.search(shown):
        return True
    pairs = zip(map(float, NUMBER.findall(shown)), map(float, NUMBER.findall(printed)))
    return all(abs(a - b) <= 1e-6 * max(abs(a), abs(b)) + 1e-13 for a, b in pairs)


def aligned(shown, printed):
    """The printed lines in place of those shown, "..." standing for any number of them; None where they differ."""
    if not shown:
        return None if printed else []
    if shown[0] == REST[0]:
        rests = (aligned(shown[1:], printed[k:]) for k in range(len(printed) + 1))
        return next((REST + rest for rest in rests if rest is not None), None)
    rest = aligned(shown[1:], printed[1:]) if printed and same_line(shown[0], printed[0]) else None
    return rest if rest is None else printed[:1] + rest


def first_words(answer):
    """What of an answer of `choose` does not depend on the machine: run: fdebench solve SCENE."""
    return answer.partition(" --scheme ")[0]


@functools.cache
def python_with_numpy():
    """The interpreter that the examples need; None where there is none."""
    for python in [sys.executable, "/usr/bin/python3"]:
        if subprocess.run([python, "-c", "import numpy"], capture_output=True, check=False).returncode == 0:
            return python
    return None


def now(command, shown, printed):
    """What the page has to show of what was printed; None where that is not what it shows."""
    if not shown or "fdebench choose" not in command:
        return aligned(shown, printed) if shown else []
    if not printed or first_words(shown[0]) != first_words(printed[0]):
        return None
    return printed[: shown.index(REST[0])] + REST if REST[0] in shown else printed


def runs(page, fdebench):
    """Runs the blocks of a page: (block, (command, what the page has to show, what was printed) of each of its commands)."""
    python = python_with_numpy()
    with tempfile.TemporaryDirectory() as folder, tempfile.TemporaryDirectory() as programs:
        for shown in ("docs", "benchmarks"):
            Path(folder, shown).symlink_to(ROOT / shown)
        Path(programs, "fdebench").symlink_to(Path(fdebench).resolve())
        if python:
            Path(programs, "python3").write_text(f'#!/bin/sh\nexec {python} "$@"\n')
            Path(programs, "python3").chmod(0o755)
        environment = {**os.environ, "PATH": os.pathsep.join([programs, os.environ["PATH"]]), "FDEBENCH_CACHE": ""}
        for block in BLOCK.findall(page.read_text()):
            parts = commands(block)
            if not any(shown for _, shown in parts) or ("python3" in block and not python):
                continue
            outcomes = []
            for command, shown in parts:
                done = subprocess.run(["bash", "-c", command], cwd=folder, env=environment, stdout=subprocess.PIPE,
                                      stderr=subprocess.STDOUT, text=True, check=False)
                printed = done.stdout.splitlines()
                outcomes.append((command, now(command, shown, printed), printed))
            yield block, outcomes


def fault(page, command, printed):
    return f"{page.relative_to(ROOT)}: {command}: prints\n  " + "\n  ".join(printed[:20])


def faults(page, fdebench):
    for _, outcomes in runs(page, fdebench):
        yield from (fault(page, command, printed) for command, shown, printed in outcomes if shown is None)


def pages_to_run():
    return [page for page in [ROOT / "README.md", *sorted((ROOT / "docs").glob("*.md"))] if page.name not in ELSEWHERE]


def main(fdebench, *names):
    pages = [ROOT / name for name in names] or pages_to_run()
    found = [line for page in pages for line in faults(page, fdebench)]
    print(*(found or ["every command prints what its page shows"]), sep="\n")
    return bool(found)


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
