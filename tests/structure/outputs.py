#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What pages say that commands print is what they print: outputs.py FDEBENCH [PAGE]...

In the `console` blocks of README.md and docs/ a command follows "$ ", further lines of it follow "> ", and what comes after is its
output, where "..." stands for any lines. A block is run in a folder of its own; a page's blocks share it. Numbers are compared to
six digits, but not in lines with times, and of `choose`, whose answer depends on the machine, the first line up to the scheme. A
block that shows no output is not run. One line for each fault.
"""

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


def same(shown, printed):
    """Whether lines are those shown, "..." standing for any number of them."""
    if not shown:
        return not printed
    if shown[0] == REST[0]:
        return any(same(shown[1:], printed[k:]) for k in range(len(printed) + 1))
    return bool(printed) and same_line(shown[0], printed[0]) and same(shown[1:], printed[1:])


def first_words(answer):
    """What of an answer of `choose` does not depend on the machine: run: fdebench solve SCENE."""
    return answer.partition(" --scheme ")[0]


def python_with_numpy():
    """The interpreter that the examples need; None where there is none."""
    for python in [sys.executable, "/usr/bin/python3"]:
        if subprocess.run([python, "-c", "import numpy"], capture_output=True, check=False).returncode == 0:
            return python
    return None


def faults(page, fdebench):
    python = python_with_numpy()
    with tempfile.TemporaryDirectory() as folder, tempfile.TemporaryDirectory() as programs:
        Path(folder, "docs").symlink_to(ROOT / "docs")
        Path(programs, "fdebench").symlink_to(Path(fdebench).resolve())
        if python:
            Path(programs, "python3").write_text(f'#!/bin/sh\nexec {python} "$@"\n')
            Path(programs, "python3").chmod(0o755)
        path = os.pathsep.join([programs, os.environ["PATH"]])
        for block in BLOCK.findall(page.read_text()):
            parts = commands(block)
            if not any(shown for _, shown in parts) or ("python3" in block and not python):
                continue
            for command, shown in parts:
                done = subprocess.run(["bash", "-c", command], cwd=folder, env={**os.environ, "PATH": path, "FDEBENCH_CACHE": ""},
                                      stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
                printed = done.stdout.splitlines()
                wanted = shown
                if shown and "fdebench choose" in command:
                    wanted, printed = [first_words(shown[0])], [first_words(printed[0])]
                if shown and not same(wanted, printed):
                    yield f"{page.relative_to(ROOT)}: {command}: prints\n  " + "\n  ".join(printed[:20])


def main(fdebench, *names):
    pages = [ROOT / name for name in names] or [ROOT / "README.md", *sorted((ROOT / "docs").glob("*.md"))]
    found = [fault for page in pages if page.name not in ELSEWHERE for fault in faults(page, fdebench)]
    print(*(found or ["every command prints what its page shows"]), sep="\n")
    return bool(found)


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
