#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""printed.py FDEBENCH: the values that other codes print (benchmarks/peers/printed.toml) have as many correct digits as are said there,
neither fewer nor more. One line for each fault."""

import csv
import subprocess
import sys
import tomllib
from fractions import Fraction
from pathlib import Path

PEERS = Path(__file__).resolve().parents[2] / "benchmarks/peers"


def exact(problem, column, t):
    """The value of a column and the bound of it, as the program knows them."""
    ran = subprocess.run([sys.argv[1], "exact", str(PEERS / f"problems/{problem}.toml"), "--at", repr(t)], capture_output=True, text=True)
    if ran.returncode:
        raise ValueError(ran.stderr.strip())
    row = list(csv.DictReader(ran.stdout.splitlines()))[-1]
    return Fraction(row[column]), Fraction(row["bound"]) + abs(Fraction(row[column])) / 2**53


def last_digit(text):
    """The unit of the last printed digit, 0 of a quotient."""
    return 0 if "/" in text else Fraction(1, 10 ** len(text.partition(".")[2]))


def correct_digits(printed, known):
    """The largest n with |printed - known| <= 10^-n |known| / 2."""
    n = 0
    while abs(printed - known) <= abs(known) / 2 / 10 ** (n + 1):
        n += 1
    return n


def fault(problem, column, t, text, digits=None):
    printed, (known, bound) = Fraction(text), exact(problem, column, t)
    if digits is None:
        right, found = abs(printed - known) <= last_digit(text) / 2 + bound, "its last digit is wrong"
    else:
        found = f"{correct_digits(printed, known)} digits of it are correct, not {digits}"
        right = correct_digits(printed, known) == digits and abs(printed - known) > bound
    return None if right else f"{problem} at t = {t}: {text} is printed, {column} is {float(known)!r} to {float(bound):.1e}: {found}"


def main():
    values = [(one["problem"], one["column"], *value) for one in tomllib.loads((PEERS / "printed.toml").read_text())["printed"] for value in one["values"]]
    faults = [text for value in values if (text := fault(*value))]
    print(*(faults or [f"{len(values)} printed values have the digits that are said"]), sep="\n")
    return bool(faults or not values)


sys.exit(main())
