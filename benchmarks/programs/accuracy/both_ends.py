#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Problems at both ends with T in (0, 20] and random coefficients: how many `fdebench solve` and `fdebench exact` solve.

usage: benchmarks/programs/accuracy/both_ends.py FDEBENCH [--seed N] [--problems N] [--steps N]

For each scene, with default and with random coefficients: the numbers of problems that `solve` and `exact` solve, and of those that
both solve the number whose q at T/2 agree to 0.01 (1 + |q|). The two have no discretisation in common (product rule, collocation).
Prints the arguments of each problem for which they differ.
"""

import argparse
import csv
import io
import random
import subprocess

SCENES = {"fractional_vakonomic": {}, "two_sided_constraint": {"motion": "given"}, "fractional_hamilton": {"motion": "given"}}
COEFFICIENTS = {
    "fractional_vakonomic": ("a1", "a2", "b1", "b2", "c1", "c2", "k1", "k2", "x1", "x2", "F0", "F1", "omega"),
    "two_sided_constraint": ("a1", "a2", "b1", "b2", "c1", "c2", "k1", "k2", "k3", "x1", "x2", "F0", "F1", "omega"),
    "fractional_hamilton": ("kappa", "epsilon", "k1", "k2", "x1", "x2", "end1", "end2"),
}
POSITIVE = {"k1", "k2", "k3"}


def middle(words, end):
    """q1 and q2 at T/2; None if the command fails."""
    ended = subprocess.run([*words, "--at", repr(end / 2)], capture_output=True, text=True, check=False)
    if ended.returncode != 0:
        return None
    row = next(csv.DictReader(io.StringIO(ended.stdout)))
    return [float(row[name]) for name in ("q1", "q2")]


def drawn(draw, scene, with_coefficients):
    chosen = {"T": round(draw.uniform(0.05, 20.0), 2), **SCENES[scene]}
    if with_coefficients:
        chosen["alpha"] = round(draw.uniform(0.1, 0.95), 2)
        for name in COEFFICIENTS[scene]:
            chosen[name] = round(draw.uniform(0.1 if name in POSITIVE else -2.0, 3.0), 2)
    return chosen


def scan(program, draw, scene, with_coefficients, problems, steps):
    solved = known = both = agree = 0
    for _ in range(problems):
        chosen = drawn(draw, scene, with_coefficients)
        words = [scene, *(word for name, value in chosen.items() for word in ("--set", f"{name}={value}"))]
        by_scheme = middle([program, "solve", *words, "--scheme", "product_trapezoidal", "--steps", str(steps)], chosen["T"])
        by_reference = middle([program, "exact", *words], chosen["T"])
        solved += by_scheme is not None
        known += by_reference is not None
        if by_scheme is None or by_reference is None:
            continue
        both += 1
        off = max(abs(a - b) / (1.0 + abs(b)) for a, b in zip(by_scheme, by_reference))
        agree += off <= 0.01
        if off > 0.01:
            print(f"off by {off:.2g}: {' '.join(words)}", flush=True)
    which = "random coefficients" if with_coefficients else "those of its list"
    print(f"{scene}, {which}: {problems} problems, solve {solved}, exact {known}, both {both}, of which {agree} agree", flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", metavar="FDEBENCH")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--problems", type=int, default=40, help="of each kind")
    parser.add_argument("--steps", type=int, default=1024)
    arguments = parser.parse_args()
    draw = random.Random(arguments.seed)
    for scene in SCENES:
        for with_coefficients in (False, True):
            scan(arguments.program, draw, scene, with_coefficients, arguments.problems, arguments.steps)


if __name__ == "__main__":
    main()
