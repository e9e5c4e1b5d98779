#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""many_runs.py FDEBENCH RUNS FILE: writes a results file with at least so many runs.

The runs are real: `relaxation` at three orders and three rates by six schemes with seven numbers of steps. They are
written again and again, each time as those of other rates: the k-th copy has the rate (1 + k/10000) lambda. So the
file is that of a family with two parameters, whose errors and times repeat.
"""

import json
import re
import subprocess
import sys
import tempfile
from pathlib import Path

SCHEMES = ("l1", "grunwald_letnikov", "bdf2", "product_trapezoidal", "fractional_trapezoidal", "adams_pc")
SCENES = [f"relaxation:gamma={gamma},lambda={rate}" for gamma in (0.1, 0.5, 0.9) for rate in (-2, -1e3, -1e6)]
STEPS = "16,32,64,128,256,512,1024"
RATE = re.compile(r'"lambda":(-[^,}]+)')


def each(option, values):
    return [word for value in values for word in (option, value)]


def measured(program, steps=STEPS):
    """The lines of a real sweep."""
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "few.jsonl"
        subprocess.run([program, "run", *each("--scene", SCENES), *each("--scheme", SCHEMES), "--steps", steps, "--repeat", "1",
                        "--out", file], check=True, capture_output=True)  # fmt: skip
        return file.read_text().splitlines(keepends=True)


def write_copies(lines, runs, file):
    """Writes the lines of a session as often as that many runs take; returns how many runs that is."""
    first, *lines = lines
    of_copy = sum('"ending":' in line for line in lines)
    copies = -(-runs // of_copy)
    with Path(file).open("w") as out:
        out.write(first)
        for k in range(copies):
            factor = 1 + k / 10000
            out.writelines(RATE.sub(lambda rate, factor=factor: f'"lambda":{json.dumps(float(rate[1]) * factor)}', line) for line in lines)
    return copies * of_copy


if __name__ == "__main__":
    if len(sys.argv) != 4:
        sys.exit(__doc__.splitlines()[0])
    print(write_copies(measured(sys.argv[1]), int(sys.argv[2]), sys.argv[3]), "runs")
