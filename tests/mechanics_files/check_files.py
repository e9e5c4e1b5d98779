#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""check_files.py FDEBENCH FILE...: `exact` and `solve` have the values of expected.json, computed by independent.py.

`exact` is off by no more than its bound and the error of the values, and by no more than 1e-10. `solve` by product_trapezoidal is
within 1e-5 in every formulation, so that they agree; its error falls by at least the first power of the step. Formulations that do
not exist are refused."""

import csv
import io
import json
import math
import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

HERE = Path(__file__).parent
PROGRAM, *FILES = sys.argv[1:]
EXPECTED = json.loads((HERE / "expected.json").read_text())
STEPS = (780, 4680)
FORMULATIONS = ("integrated", "multiplier", "acceleration", "stabilised")
# v' starts like t^-0.6, where these two need an order below 1/2.
REFUSED = {(name, form) for name in ("two_orders", "two_orders_nonlinear") for form in ("acceleration", "stabilised")}
# Extrema are not constrained motions.
WITHOUT_FORMULATIONS = {"fractional_lagrangian", "fractional_vakonomic_pair"}
# The reference has multipliers where the constraint has no memory, and where all is linear.
EXACT_MULTIPLIERS = {"rolling_disc_friction", "two_orders"}


def run(cache, *words):
    return subprocess.run([PROGRAM, *words], capture_output=True, text=True, env={**os.environ, "FDEBENCH_CACHE": cache})


class Files(unittest.TestCase):
    def setUp(self):
        cache = tempfile.TemporaryDirectory()
        self.addCleanup(cache.cleanup)
        self.cache = cache.name

    def values(self, name, *words):
        """The columns that a command prints at the times of expected.json."""
        times = EXPECTED[f"{name}.toml"]["times"]
        ended = run(self.cache, *words, "--at", ",".join(map(repr, times)))
        self.assertEqual(ended.returncode, 0, ended.stderr)
        rows = list(csv.DictReader(io.StringIO(ended.stdout)))
        self.assertEqual([float(row["t"]) for row in rows], times)
        return {column: [float(row[column]) for row in rows] for column in rows[0]}

    def errors(self, found, expected):
        """The largest error of each expected column; a column that is not there is an error of the test."""
        return {column: max(abs(a - b) for a, b in zip(found[column], values, strict=True)) for column, values in expected.items()}

    def check_exact(self, name, entry):
        expected = entry["columns"] | (entry["multipliers"] if name in EXACT_MULTIPLIERS else {})
        found = self.values(name, "exact", str(HERE / f"{name}.toml"), "--bounds")
        own = 10.0 ** -entry["digits"]
        for column, error in self.errors(found, expected).items():
            bound = max(found["bound"] if column.startswith("lambda") else found[f"bound_{column}"])
            self.assertLessEqual(error, bound + own, f"exact {column}, bound {bound}")
            self.assertLessEqual(error, 1e-10, f"exact {column}")

    def check_solve(self, name, entry, *choice):
        expected = entry["columns"] | entry.get("multipliers", {})
        words = ("solve", str(HERE / f"{name}.toml"), *choice, "--scheme", "product_trapezoidal", "--steps")
        coarse, fine = (self.errors(self.values(name, *words, str(steps)), expected) for steps in STEPS)
        for column, error in fine.items():
            self.assertLessEqual(error, 1e-5, f"{choice} {column}")
        rate = math.log(max(coarse.values()) / max(fine.values())) / math.log(STEPS[1] / STEPS[0])
        self.assertGreaterEqual(rate, 1.0, f"{choice} {coarse} {fine}")

    def check_refused(self, name, *choice):
        ended = run(self.cache, "solve", str(HERE / f"{name}.toml"), *choice, "--scheme", "product_trapezoidal", "--steps", "8")
        self.assertEqual((ended.returncode, ended.stdout, ended.stderr.count("\n")), (2, "", 1), ended.stderr)
        self.assertIn("formulation", ended.stderr)

    def test_have_the_independent_values(self):
        for name in FILES:
            entry = EXPECTED[f"{name}.toml"]
            with self.subTest(name):
                self.check_exact(name, entry)
            if name in WITHOUT_FORMULATIONS:
                with self.subTest(name):
                    self.check_solve(name, entry)
                    self.check_refused(name, "--set", "formulation=integrated")
                continue
            for form in FORMULATIONS:
                with self.subTest(name, formulation=form):
                    choice = ("--set", f"formulation={form}")
                    if (name, form) in REFUSED:
                        self.check_refused(name, *choice)
                    else:
                        self.check_solve(name, entry, *choice)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
