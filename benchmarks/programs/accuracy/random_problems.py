#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Runs with random tolerances on scenes with random parameters, compared with `fdebench exact`.

usage: benchmarks/programs/accuracy/random_problems.py FDEBENCH [--seed N] [--seconds S] [--constrained]

Prints a line for each run whose error exceeds ten times the tolerance, as a multiple of it, or that did not finish; then a table
with the numbers of runs, of such errors, and of those without a warning. The error is the largest of |error| / (1 + |y|) over
columns and 28 times, minus the bound of the reference; multipliers are counted separately. With --constrained the problems are
mechanical systems with constraints. Exit code 1 if a finished run has such an error without a warning.
"""

import argparse
import random
import subprocess
import sys
import time

SCHEMES = {"spectral_collocation": 13, "radau_exponentials": 9, "adaptive_trapezoidal": 6, "adaptive_pc": 6}  # largest number of digits
NOT_FOR_STIFF = {"stiff_relaxation", "robertson", "van_der_pol", "damped_oscillator"}
LIMIT = 10.0


def problem(draw):
    """A scene with random parameters: its id, its argument on the command line, and its end."""

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


def constrained_problem(draw):
    """The same for mechanical systems with constraints."""

    def number(low, high):
        return round(draw.uniform(low, high), 3)

    def place(*names, size=1.0):
        return {name: number(-size, size) for name in names}

    form = draw.choice(["multiplier", "integrated", "acceleration", "stabilised"])
    parameters = draw.choice([
        {"scene": "isokinetic", "k": number(0.5, 20), "c": number(0, 5), **place("q1", "q2", "q3", "v1", "v2", "v3"), "formulation": form},
        {"scene": "knife_edge", "g": number(0, 10), "theta": number(0.1, 1.4), "omega": number(0.5, 5), "formulation": form},
        {"scene": "blade_on_sphere", "theta0": number(0.8, 2.2), "psi0": number(-3, 3), "speed": number(0.1, 1), "spin": number(0.5, 5),
         "inertia": number(0.1, 1), "gravity": number(0, 2), "formulation": form},
        {"scene": "rolling_disc", "pull": number(0, 1), "dphi0": number(-2, 2), "dpsi0": number(-3, 3), "formulation": form},
        {"scene": "nonholonomic_particle", "y0": number(-1, 1), "dx0": number(-1, 1), "dy0": number(-1, 1), "formulation": form},
        {"scene": "fractional_constraint_2d", "alpha": number(0.1, 0.95), **place("a1", "b1", "b2", "q1", "q2", "v1", "v2"), "a2": number(0.3, 2),
         "k1": number(0.5, 15), "k2": number(0.5, 15), "formulation": draw.choice(["multiplier", "integrated"])},
        {"scene": "fractional_constraint_nonlinear", "alpha": number(0.1, 0.9), "coupling": number(-0.5, 0.5), "formulation": "multiplier"},
        {"scene": "fractional_knife_edge", "surface": draw.choice(["plane", "sphere"]), "alpha": number(0.3, 0.95)},
    ])
    end = draw.choice((2, 5, 10))
    settings = ",".join(f"{name}={value}" for name, value in parameters.items() if name != "scene")
    return parameters["scene"], f"{parameters['scene']}:{settings},until={end}", end


def table(words):
    """Columns and rows of the CSV output and the standard error; or None and the error message."""
    answer = subprocess.run(words, capture_output=True, text=True, check=False)
    if answer.returncode != 0:
        return None, answer.stderr.strip()
    first, *lines = answer.stdout.strip().split("\n")
    return first.split(","), [[float(cell) for cell in line.split(",")] for line in lines], answer.stderr


def largest_error(exact, solved, multipliers):
    """The largest error over the common columns: over multipliers only, or over all others except energy and drift."""
    names, references = exact[:2]
    columns, rows = solved[:2]
    left_out = {"t", "bound", "energy", "constraint", "power"}
    shown = [name for name in names if name in columns and name not in left_out and name.startswith("lambda") == multipliers]
    bound = names.index("bound")
    errors = [(abs(reference[names.index(name)] - row[columns.index(name)]) - reference[bound]) / (1 + abs(reference[names.index(name)]))
              for reference, row in zip(references, rows) for name in shown]
    return max(errors, default=0.0)


def main():
    """Draws and runs problems until the time is over."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("fdebench")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--seconds", type=float, default=600)
    parser.add_argument("--constrained", action="store_true")
    arguments = parser.parse_args()
    draw = random.Random(arguments.seed)
    until = time.monotonic() + arguments.seconds
    counts = {scheme: dict.fromkeys(("runs", "off", "multipliers off", "of these in silence", "off at most"), 0) for scheme in SCHEMES}
    while time.monotonic() < until:
        scene, name, end = constrained_problem(draw) if arguments.constrained else problem(draw)
        times = sorted({end * i / 16 for i in range(1, 17)} | {end * 10 ** (-i / 2) for i in range(1, 13)})
        at = ",".join(repr(t) for t in times)
        exact = table([arguments.fdebench, "exact", name, "--at", at, "--budget", "20"])
        if exact[0] is None:
            continue
        for scheme, digits in SCHEMES.items():
            accuracy = float(f"{10 ** -draw.uniform(3, digits):.1e}")
            if scheme == "adaptive_pc" and scene in NOT_FOR_STIFF:
                continue
            solved = table([arguments.fdebench, "solve", name, "--scheme", scheme, "--accuracy", repr(accuracy), "--at", at,
                            "--budget", "20"])
            if solved[0] is None:
                if " takes no " not in solved[1] and "steps explicitly" not in solved[1]:
                    print(f"ended  {scheme} {accuracy} {name}: {solved[1]}", flush=True)
                continue
            count = counts[scheme]
            count["runs"] += 1
            off, of_multipliers = (largest_error(exact, solved, which) / accuracy for which in (False, True))
            count["off at most"] = max(count["off at most"], float(f"{max(off, of_multipliers):.2g}"))
            if max(off, of_multipliers) <= LIMIT:
                continue
            silent = "times the requested accuracy" not in solved[2]
            count["off"] += off > LIMIT
            count["multipliers off"] += of_multipliers > LIMIT
            count["of these in silence"] += silent
            print(f"{'silent' if silent else 'warned'} {off:<8.3g} {of_multipliers:<8.3g} {scheme} {accuracy} {name}", flush=True)
    columns = list(next(iter(counts.values())))
    print(f"| by more than {LIMIT:g} times | {' | '.join(columns)} |\n|{'---|' * (len(columns) + 1)}")
    for scheme, count in counts.items():
        print(f"| `{scheme}` | {' | '.join(str(count[column]) for column in columns)} |")
    return 1 if any(count["of these in silence"] for count in counts.values()) else 0


if __name__ == "__main__":
    sys.exit(main())
