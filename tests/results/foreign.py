#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""foreign.py FDEBENCH WORD...: the program of docs/examples that these words run, `python3 relaxation.py` or
`octave-cli relaxation.m`, is judged, and is listed with our runs on the page and in the answers."""

import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "support"))
from page_data import data_of  # noqa: E402

PROGRAM, *WORDS = sys.argv[1:]
NAME = Path(WORDS[0]).name.split(".")[0].rstrip("0123456789") + " λ"


def run(*words):
    return subprocess.run(list(map(str, words)), capture_output=True, text=True)


class Foreign(unittest.TestCase):
    def test_is_judged_and_shown_beside_ours(self):
        with tempfile.TemporaryDirectory() as folder:
            written, results = Path(folder) / "written.csv", Path(folder) / "results.jsonl"
            errors = []
            for steps in (64, 128, 256, 512):
                seconds = run(*WORDS, steps, written).stdout.strip()
                judged = run(PROGRAM, "judge", "relaxation", written, "--seconds", seconds, "--name", NAME, "--out", results)
                self.assertEqual(judged.returncode, 0, judged.stderr)
                self.assertIn("ending finished\n", judged.stdout)
                self.assertIn(f"rows {steps + 1}\n", judged.stdout)
                self.assertIn(f"time_minimum {float(seconds):g}"[:20], judged.stdout)
                errors.append(float(re.search(r"error_end (\S+)", judged.stdout)[1]))
            # Both rules are of first order at t > 0 where the solution starts like a root of t.
            for coarse, fine in zip(errors, errors[1:]):
                self.assertAlmostEqual(coarse / fine, 2.0, delta=0.2)
            ours = run(PROGRAM, "run", "--scene", "relaxation", "--scheme", "l1", "--scheme", "grunwald_letnikov", "--steps",
                       "64,128,256,512", "--out", results)
            self.assertEqual(ours.returncode, 0, ours.stderr)
            chosen = run(PROGRAM, "choose", "relaxation", "--error", "5e-2", "--results", results)
            self.assertRegex(chosen.stdout, rf"(?m)^{NAME} +\d+ ")
            self.assertRegex(chosen.stdout, r"(?m)^l1 +\d+ ")
            reported = run(PROGRAM, "report", results, "--out", folder)
            if "no charts" in reported.stderr:
                self.skipTest("a build without charts")
            self.assertEqual(reported.returncode, 0, reported.stderr)
            page = (Path(folder) / "index.html").read_text()
            data = data_of(page)
            self.assertCountEqual(data["lines"], ["l1", "grunwald_letnikov", NAME])
            runs = next(section["runs"] for section in data["sections"] if section["id"] == "scene-relaxation")
            self.assertEqual(runs["line"].count(runs["lines"].index(NAME)), 4)
            self.assertTrue(all(seconds > 0 for seconds in runs["time_minimum"]))

    def test_is_the_scheme_that_it_says(self):
        """The same rule over the same grid, so the same numbers up to rounding."""
        scheme = "l1" if WORDS[-1].endswith(".py") else "grunwald_letnikov"
        with tempfile.TemporaryDirectory() as folder:
            written = Path(folder) / "written.csv"
            run(*WORDS, 64, written)
            ours = run(PROGRAM, "solve", "relaxation", "--scheme", scheme, "--steps", 64).stdout.split()[1:]
            theirs = written.read_text().split("\n")[1:66]
            for one, other in zip(ours, theirs, strict=True):
                self.assertAlmostEqual(float(one.split(",")[1]), float(other.split(",")[1]), delta=1e-13)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
