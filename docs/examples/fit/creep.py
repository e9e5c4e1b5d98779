#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Measurements of creep, made up: the exact solution of creep.toml for a truth that the file does not have, with Gaussian noise.

creep.py > creep.csv
"""

import csv
import random
import subprocess
from pathlib import Path

TRUTH = {"alpha": 0.6, "E0": 1.2, "E1": 2.5, "tau": 1.0}
DEVIATION = 0.004
COUNT = 40

noise = random.Random(3)
times = [20 * (k / COUNT) ** 2 for k in range(1, COUNT + 1)]  # dense at the start, where the strain changes most
chosen = ",".join(f"{name}={value}" for name, value in TRUTH.items())
known = subprocess.run(["fdebench", "exact", f"{Path(__file__).with_name('creep.toml')}:{chosen}", "--at", ",".join(map(str, times))],
                       check=True, capture_output=True, text=True)
print("t,strain,sd_strain")
for row in csv.DictReader(known.stdout.splitlines()):
    print(f"{float(row['t']):.4g},{float(row['strain']) + noise.gauss(0, DEVIATION):.4f},{DEVIATION}")
