#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""problems.py FDEBENCH: every file of benchmarks/peers/problems has a reference, which agrees at the end with spectral_collocation.
One line for each fault."""

import csv
import subprocess
import sys
from pathlib import Path

FILES = sorted((Path(__file__).resolve().parents[2] / "benchmarks/peers/problems").glob("*.toml"))
ALLOWED = 1e-8  # of the largest unknown: the bound of the reference, and the difference


def last_row(*arguments):
    ran = subprocess.run([sys.argv[1], *arguments], capture_output=True, text=True)
    if ran.returncode:
        raise ValueError(ran.stderr.strip())
    return {name: float(value) for name, value in list(csv.DictReader(ran.stdout.splitlines()))[-1].items()}


def fault(file):
    try:
        solved = last_row("solve", file, "--scheme", "spectral_collocation", "--accuracy", "1e-12", "--points", "2")
        exact = last_row("exact", file, "--at", repr(solved["t"]), "--bounds")
    except ValueError as error:
        return str(error)
    scale = max(abs(exact[name]) for name in solved if name != "t")
    difference = max(abs(solved[name] - exact[name]) for name in solved)
    if not exact["bound"] <= ALLOWED * scale:
        return f"the reference is known to {exact['bound']:.1e}, of {scale:.1e}"
    if not difference <= ALLOWED * scale:
        return f"differs from spectral_collocation by {difference:.1e}, of {scale:.1e}"
    return None


def main():
    faults = [f"{file.name}: {text}" for file in FILES if (text := fault(str(file)))]
    print(*(faults or [f"{len(FILES)} problems agree with spectral_collocation"]), sep="\n")
    return bool(faults or not FILES)


sys.exit(main())
