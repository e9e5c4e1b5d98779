#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""delay_by_laplace.py FDEBENCH: the solution of benchmarks/peers/problems/delay_wang_rest.toml by an inverse Laplace transform.

With y = t^2 - t + d the equation is D^a d = -d + d(t - tau), d = t - t^2 for t < 0, d(0) = 0. So with the transform H of the function
that is d(t - tau) up to tau and then 0, and D that of d:

    D = H / (s^a + 1 - e^(-s tau)) = sum over k of e^(-k s tau) H / (s^a + 1)^(k + 1),   H = P - e^(-s tau) Q,

P and Q being the transforms of d(t - tau) and d(t), t - t^2 continued to all t. Each term is smooth behind its delay. Needs mpmath."""

import csv
import subprocess
import sys
from pathlib import Path

from mpmath import ceil, invertlaplace, mp, mpf

FILE = Path(__file__).resolve().parents[2] / "benchmarks/peers/problems/delay_wang_rest.toml"
TIMES = ("0.3", "0.5", "1", "2", "5")
ALPHA = TAU = mpf("0.5")


def before_delay(s):
    return -2 / s**3 + (1 + 2 * TAU) / s**2 - (TAU + TAU**2) / s


def behind_delay(s):
    return 1 / s**2 - 2 / s**3


def part(transform, k, t):
    """The function with the transform `transform`(s) / (s^a + 1)^(k + 1), 0 up to t = 0."""
    return invertlaplace(lambda s: transform(s) / (s**ALPHA + 1) ** (k + 1), t, method="talbot", degree=50) if t > 0 else 0


def solution(t):
    delays = range(int(ceil(t / TAU)))
    return t**2 - t + sum(part(before_delay, k, t - k * TAU) - part(behind_delay, k, t - (k + 1) * TAU) for k in delays)


def main():
    mp.dps = 40
    ran = subprocess.run([sys.argv[1], "exact", FILE, "--at", ",".join(TIMES)], capture_output=True, text=True, check=True)
    faults = []
    for row in csv.DictReader(ran.stdout.splitlines()):
        known = solution(mpf(row["t"]))
        if abs(known - mpf(row["y"])) > mpf(row["bound"]) + mpf("1e-16"):
            faults.append(f"t = {row['t']}: y = {row['y']} to {row['bound']}, by the Laplace transform {mp.nstr(known, 17)}")
    print(*(faults or [f"{len(TIMES)} values agree with the inverse Laplace transform"]), sep="\n")
    return bool(faults)


sys.exit(main())
