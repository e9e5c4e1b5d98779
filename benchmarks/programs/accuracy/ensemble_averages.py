#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Averages over long motions of the chains with a thermostat, beside those of the densities that docs/mechanics.md says are stationary.

usage: benchmarks/programs/accuracy/ensemble_averages.py FDEBENCH [--seed N] [--motions N] [--until T] [--step H]

Each motion starts at other places, and with another velocity where one is free. Printed are the averages over T, their mean over the
motions with its standard error, and the exact value: 1 for q du/dq and v^2 of a degree of freedom, 3 for v^4/T^2. Under the
piston the springs' lengths are independent: the variance of the length is three times that of a spring. The multiplier form keeps the
constraint, the trapezoidal rule is off by (step)^2. The motions are chaotic: what `solve` warns of their last times is left out.
"""

import argparse
import math
import random
import statistics
import subprocess

SPEEDS = (0.6, -0.4)


def spring(k, c, length):
    return k * length + c * length**3


def slopes(k, c, q, pressure):
    """du/dq of the chain between walls; with a pressure that of the chain under the piston."""
    first, second, third = spring(k, c, q[0]), spring(k, c, q[1] - q[0]), spring(k, c, q[2] - q[1])
    return first - second, second - third, third + (spring(k, c, q[2]) if pressure is None else pressure)


class Motion:
    def __init__(self, program, scene, settings, args, draw):
        self.k, self.c = settings.get("k", 1.0), settings.get("c", 0.5)
        self.pressure = settings.get("pressure", 0.5) if scene == "isobaric_ensemble" else None
        start = {f"q{i}": round(draw.gauss(0, 0.5), 3) for i in (1, 2, 3)}
        start |= {"v1": SPEEDS[0], "v2": SPEEDS[1], "v3": 0.3 if scene == "isokinetic" or settings.get("gamma3") else round(draw.gauss(0, 0.7), 3)}
        chosen = [word for name, value in (settings | start).items() for word in ("--set", f"{name}={value}")]
        steps = str(math.ceil(args.until / args.step))
        command = [program, "solve", scene, "--scheme", "product_trapezoidal", "--steps", steps, "--until", str(args.until)]
        self.process = subprocess.Popen([*command, *chosen, "--set", "formulation=multiplier"], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)

    def averages(self, temperature):
        sums, count = [0.0] * 9, 0
        next(self.process.stdout)
        for number, line in enumerate(self.process.stdout):
            if number % 4:
                continue
            _, *row = map(float, line.split(",")[:7])
            q, v = row[:3], row[3:]
            slope = slopes(self.k, self.c, q, self.pressure)
            terms = [*(q[i] * slope[i] / temperature for i in range(3)), *(v[i] ** 2 / temperature for i in range(3)),
                     v[2] ** 4 / temperature**2, q[2], q[2] ** 2]  # fmt: skip
            sums = [before + term for before, term in zip(sums, terms)]
            count += 1
        if self.process.wait() != 0:
            raise SystemExit("fdebench ended with an error")
        means = [term / count for term in sums]
        return [*means[:8], means[8] - means[7] ** 2]


NAMES = ("q1 du/dq1", "q2 du/dq2", "q3 du/dq3", "v1^2", "v2^2", "v3^2", "v3^4", "<q3>", "var q3")


def show(args, scene, temperature, settings):
    draw = random.Random(args.seed)
    rows = [Motion(args.fdebench, scene, settings, args, draw).averages(temperature) for _ in range(args.motions)]
    print(f"{scene} {settings} T = {temperature:g}")
    for name, values in zip(NAMES, zip(*rows)):
        error = statistics.stdev(values) / math.sqrt(len(values))
        print(f"  {name:10} {statistics.mean(values):8.4f} +- {error:.4f}")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("fdebench")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--motions", type=int, default=6)
    parser.add_argument("--until", type=float, default=10000.0)
    parser.add_argument("--step", type=float, default=0.05)
    args = parser.parse_args()
    square = SPEEDS[0] ** 2 + SPEEDS[1] ** 2
    show(args, "canonical_ensemble", square, {})
    show(args, "isobaric_ensemble", square, {})
    show(args, "isobaric_ensemble", square, {"c": 0.0})
    show(args, "isokinetic", (square + 0.09) / 2, {})
    frictions = {"gamma1": 0.2, "gamma2": 0.5, "gamma3": 1.0}
    weights, speeds = list(frictions.values()), (*SPEEDS, 0.3)
    show(args, "canonical_ensemble", sum(g * v * v for g, v in zip(weights, speeds)) / sum(weights), frictions)


main()
