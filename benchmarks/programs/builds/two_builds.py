#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Compares the times of two builds of fdebench: two_builds.py FIRST SECOND [REPEATS]

Runs each solve by both programs in turn and prints the least CPU time of each and their ratio, SECOND / FIRST. For a build
without assertions: cmake -D FDEBENCH_ASSERTIONS=OFF.
"""

import resource
import subprocess
import sys

SOLVES = [
    "pendulum --scheme decoupled_multi_order --steps 3000000",
    "pendulum --scheme product_trapezoidal --steps 1000000",
    "relaxation --scheme adams_pc --steps 3000000",
    "relaxation --scheme bdf4 --steps 3000000",
    "brusselator --scheme l1 --steps 1000000",
    "brusselator --scheme grunwald_letnikov --steps 1000000",
    "knife_edge --scheme product_trapezoidal --steps 300000",
    "fractional_diffusion:components=2000 --scheme l1 --steps 2000",
    "pendulum --scheme adaptive_pc --accuracy 1e-8",
    "robertson:until=1e9 --scheme radau_exponentials --accuracy 1e-11",
]


def seconds(program, solve):
    """CPU time of one solve that prints two rows."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
    subprocess.run([program, "solve", *solve.split(), "--points", "2"], stdout=subprocess.DEVNULL, check=True)
    return resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before


def main(first, second, repeats="7"):
    print("first,second,ratio,solve")
    for solve in SOLVES:
        times = [(seconds(first, solve), seconds(second, solve)) for _ in range(int(repeats))]
        a, b = (min(column) for column in zip(*times))
        print(f"{a:.3f},{b:.3f},{b / a if a else float('nan'):.3f},{solve}", flush=True)


if __name__ == "__main__":
    main(*sys.argv[1:])
