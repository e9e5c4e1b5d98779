#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Schemes over grids of random numbers of steps, on scenes with random parameters: how many wrong runs are silent.

usage: benchmarks/programs/accuracy/random_grids.py FDEBENCH [--seed N] [--runs N] [--constrained]

A run is wrong where a column is off `fdebench exact` by more than a tenth of its largest value in the last quarter of the
steps. The columns are the unknowns; apart from them energies and multipliers, whose value counts as a hundredth of the
largest unknown or more, since some are 0; and the drift, which is wrong by more than a tenth of the largest unknown. The
power of reactions, 0 without memory, is left out. Prints a line for each wrong run without a warning, and at last a table. With --constrained
the problems are motions under constraints. Exit code 1 where an unknown was wrong in silence.
"""

import argparse
import json
import random
import subprocess
import sys

from random_problems import constrained_problem, problem, table

PART = 0.1  # of the value, of which docs/command.md promises a warning
KINDS = ("unknowns", "energies and multipliers", "drift")


def kind_of(name):
    """Which of KINDS a column belongs to."""
    if name == "constraint":
        return "drift"
    return "energies and multipliers" if name == "energy" or name.startswith("lambda") else "unknowns"


def schemes_over_grids(program):
    """The ids of the schemes that take a number of steps."""
    answer = subprocess.run([program, "schemes", "--json"], capture_output=True, text=True, check=True)
    return [scheme["id"] for scheme in json.loads(answer.stdout) if scheme["takes_grid"]]


def wrong_parts(exact, solved):
    """Of each kind of columns the largest error, as a part of the value."""
    names, references = exact[:2]
    columns, rows = solved[:2]
    shown = [name for name in columns if name in names and name not in ("t", "power")]
    value = {name: [reference[names.index(name)] for reference in references] for name in shown}
    size = {name: max(map(abs, value[name])) for name in shown}
    largest = max((size[name] for name in shown if kind_of(name) == "unknowns"), default=0.0)
    bound = max(reference[names.index("bound")] for reference in references)
    parts = dict.fromkeys(KINDS, 0.0)
    for name in shown:
        least = {"unknowns": 1e-9, "energies and multipliers": 1e-2, "drift": 1.0}[kind_of(name)]
        of_value = max(size[name], least * largest)
        off = max(abs(row[columns.index(name)] - exactly) for row, exactly in zip(rows, value[name])) - bound
        if of_value > 0.0 and off == off:
            parts[kind_of(name)] = max(parts[kind_of(name)], off / of_value)
    return parts


def main():
    """Draws and runs until there were so many runs."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("fdebench")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--runs", type=int, default=1000)
    parser.add_argument("--constrained", action="store_true")
    arguments = parser.parse_args()
    draw = random.Random(arguments.seed)
    schemes = schemes_over_grids(arguments.fdebench)
    runs = 0
    wrong = {kind: {"wrong": 0, "silent": 0} for kind in KINDS}
    false_alarms = 0
    while runs < arguments.runs:
        _, name, end = constrained_problem(draw) if arguments.constrained else problem(draw)
        at = ",".join(repr(end * i / 16) for i in range(12, 17))
        exact = table([arguments.fdebench, "exact", name, "--at", at, "--budget", "20"])
        if exact[0] is None:
            continue
        for scheme in draw.sample(schemes, 4):
            steps = 16 * round(2 ** draw.uniform(0, 8))
            solved = table([arguments.fdebench, "solve", name, "--scheme", scheme, "--steps", str(steps), "--at", at, "--budget", "20"])
            if solved[0] is None:
                continue
            runs += 1
            warned = "warning" in solved[2]
            parts = wrong_parts(exact, solved)
            false_alarms += warned and max(parts.values()) < PART / 2
            for kind, part in parts.items():
                wrong[kind]["wrong"] += part > PART
                wrong[kind]["silent"] += part > PART and not warned
            if max(parts.values()) > PART and not warned:
                print(f"silent {' '.join(f'{part:<8.3g}' for part in parts.values())} {name} --scheme {scheme} --steps {steps}", flush=True)
    print(f"{runs} runs, {false_alarms} warned of that are off by less than {PART / 2:g}\n| | wrong | of these in silence |\n|---|---|---|")
    for kind, count in wrong.items():
        print(f"| {kind} | {count['wrong']} | {count['silent']} |")
    return 1 if wrong["unknowns"]["silent"] else 0


if __name__ == "__main__":
    sys.exit(main())
