#!/usr/bin/env python3
"""Runs of random accuracies on scenes with random parameters, against `fdebench exact`.

usage: benchmarks/programs/accuracy/random_problems.py FDEBENCH [--seed N] [--seconds S]

Prints a line for each run that is off by more than ten times what was asked, in units of it, or that came to no
end, and at last how many runs there were. The error is the largest of |error| / (1 + |y|) over columns and 28 times,
the bound of the reference taken off. Exit code 1 where a run that finished was off by more.
"""

import argparse
import random
import subprocess
import sys
import time

SCHEMES = {"spectral_collocation": 13, "radau_exponentials": 9, "adaptive_trapezoidal": 6, "adaptive_pc": 6}  # digits at most
NOT_FOR_STIFF = {"stiff_relaxation", "robertson", "van_der_pol", "damped_oscillator"}
LIMIT = 10.0


def problem(draw):
    """A scene with parameters, as the command takes it, and its end."""

    def order(low, high):
        return round(draw.uniform(low, high), 3)

    def size(low, high):
        return round(10 ** draw.uniform(low, high), 3)

    gamma = order(0.05, 1.95)
    parameters, ends = draw.choice([
        ({"scene": "relaxation", "gamma": gamma, "lambda": -size(-2, 2)}, (1, 10, 100)),
        ({"scene": "relaxation_pair", "gamma": gamma, "re": -size(-1, 1), "im": size(-1, 1)}, (1, 5, 20)),
        ({"scene": "linear_system", "gamma1": gamma, "gamma2": order(0.05, 1.95)}, (1, 5, 20)),
        ({"scene": "fractional_oscillator", "nu": order(1.05, 1.95), "w2": size(-1, 2), "c0": 1}, (1, 10, 50)),
        ({"scene": "bagley_torvik", "alpha": order(0.05, 1.85), "B": size(-1, 0.3), "C": size(-1, 0.5), "load_until": size(-1, 0.4)}, (4, 16)),
        ({"scene": "damped_oscillator", "alpha": order(1.05, 1.95), "beta": order(0.05, 0.95), "w2": size(-1, 1.5)}, (5, 20)),
        ({"scene": "stiff_relaxation", "gamma": gamma, "lambda": -size(2, 8)}, (1, 10)),
        ({"scene": "diethelm", "gamma": gamma}, (1,)),
        ({"scene": "power", "gamma": gamma, "p": order(0.2, 4)}, (1, 5)),
        ({"scene": "pendulum", "alpha": order(1.05, 1.95), "beta": order(0.05, 0.95), "phi0": order(0.1, 2.5)}, (5, 20)),
        ({"scene": "brusselator", "gamma": order(0.2, 0.99)}, (5, 20)),
        ({"scene": "van_der_pol", "gamma": order(0.2, 0.99), "mu": size(-1, 3)}, (5, 20)),
        ({"scene": "multi_term", "k": size(-0.3, 0.5), "force": draw.choice(["sine", "cubic"])}, (5, 20)),
        ({"scene": "robertson", "gamma": order(0.3, 0.99)}, (40, 1000)),
        ({"scene": "fractional_constraint_1d", "alpha": order(0.05, 2.9)}, (2, 10)),
        ({"scene": "fractional_constraint_2d", "alpha": order(0.05, 0.95), "formulation": draw.choice(["integrated", "multiplier"])}, (2, 10)),
        ({"scene": "isokinetic", "formulation": draw.choice(["acceleration", "multiplier"])}, (2, 10)),
    ])
    end = draw.choice(ends)
    settings = ",".join(f"{name}={value}" for name, value in parameters.items() if name != "scene")
    return parameters["scene"], f"{parameters['scene']}:{settings},until={end}", end


def table(words):
    """Columns and rows of CSV, or the line that says why there is none."""
    answer = subprocess.run(words, capture_output=True, text=True, check=False)
    if answer.returncode != 0:
        return None, answer.stderr.strip()
    first, *lines = answer.stdout.strip().split("\n")
    return first.split(","), [[float(cell) for cell in line.split(",")] for line in lines]


def largest_error(exact, solved):
    """Over the columns that both have and are no multiplier, energy or drift."""
    names, references = exact
    columns, rows = solved
    left_out = {"t", "bound", "energy", "constraint", "power"}
    shown = [name for name in names if name in columns and name not in left_out and not name.startswith("lambda")]
    bound = names.index("bound")
    errors = [(abs(reference[names.index(name)] - row[columns.index(name)]) - reference[bound]) / (1 + abs(reference[names.index(name)]))
              for reference, row in zip(references, rows) for name in shown]
    return max(errors)


def main():
    """Draws, runs and prints until the time is over."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("fdebench")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--seconds", type=float, default=600)
    arguments = parser.parse_args()
    draw = random.Random(arguments.seed)
    until = time.monotonic() + arguments.seconds
    finished, wrong = dict.fromkeys(SCHEMES, 0), dict.fromkeys(SCHEMES, 0)
    while time.monotonic() < until:
        scene, name, end = problem(draw)
        times = sorted({end * i / 16 for i in range(1, 17)} | {end * 10 ** (-i / 2) for i in range(1, 13)})
        at = ",".join(repr(t) for t in times)
        exact = table([arguments.fdebench, "exact", name, "--at", at, "--budget", "20"])
        if exact[0] is None:
            continue
        for scheme, digits in SCHEMES.items():
            accuracy = float(f"{10 ** -draw.uniform(3, digits):.1e}")
            if scheme == "adaptive_pc" and scene in NOT_FOR_STIFF:
                continue
            solved = table([arguments.fdebench, "solve", name, "--scheme", scheme, "--accuracy", repr(accuracy), "--at", at, "--budget", "20"])
            if solved[0] is None:
                if " takes no " not in solved[1] and "steps explicitly" not in solved[1]:
                    print(f"ended  {scheme} {accuracy} {name}: {solved[1]}", flush=True)
                continue
            finished[scheme] += 1
            off = largest_error(exact, solved) / accuracy
            if off > LIMIT:
                wrong[scheme] += 1
                print(f"{off:<6.3g} {scheme} {accuracy} {name}", flush=True)
    for scheme, count in finished.items():
        print(f"{scheme}: {wrong[scheme]} of {count} runs off by more than {LIMIT:g} times what was asked")
    return 1 if any(wrong.values()) else 0


if __name__ == "__main__":
    sys.exit(main())
