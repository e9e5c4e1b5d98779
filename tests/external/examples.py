#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""examples.py FDEBENCH SCHEME WORD...: the program of docs/examples run by these words has the errors of this scheme, and is
listed with it in results, on the page and in recommendations."""

import shlex
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "support"))
from page_data import data_of  # noqa: E402

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "benchmarks" / "programs" / "records"))
from recorded_runs import runs_in  # noqa: E402

PROGRAM, SCHEME, *WORDS = sys.argv[1:]
NAME = "theirs λ"
STEPS = "64,128,256,512"


def fdebench(*words):
    return subprocess.run([PROGRAM, *map(str, words)], capture_output=True, text=True)


class Examples(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.results = Path(cls.folder.name) / "results.jsonl"
        scenes = ["--scene", "relaxation", "--scene", "relaxation:gamma=0.3,lambda=-2,y0=3,until=2", "--scene", "brusselator"]
        run = fdebench("run", *scenes, "--steps", STEPS, "--repeat", 1, "--scheme", SCHEME, "--external", f"{NAME}={shlex.join(WORDS)}", "--out",
                       cls.results)  # fmt: skip
        assert run.returncode == 0, run.stderr
        cls.runs = runs_in(cls.results)

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def values(self, scheme, quantity, settings):
        return {
            run["steps"]: {**run["values"], **run["time"]}[quantity]
            for run in self.runs
            if run["scheme"] == scheme and run["settings"] == settings and run["scene"] == "relaxation"
        }  # fmt: skip

    def test_has_the_errors_of_the_same_rule_of_ours(self):
        for settings in ({}, {"gamma": 0.3, "lambda": -2.0, "y0": 3.0, "until": 2.0}):
            for error in ("error_end", "error_maximum"):
                ours, theirs = self.values(SCHEME, error, settings), self.values(NAME, error, settings)
                self.assertEqual(list(theirs), [64, 128, 256, 512])
                for steps, value in ours.items():
                    self.assertAlmostEqual(theirs[steps] / value, 1.0, delta=1e-9)

    def test_tells_its_own_time(self):
        times = self.values(NAME, "time_minimum", {})
        self.assertEqual(len(times), 4)
        self.assertTrue(all(0.0 < seconds < 1.0 for seconds in times.values()))
        self.assertFalse(any("wall_clock" in run for run in self.runs))

    def test_says_what_it_does_not_take(self):
        endings = [run for run in self.runs if run["scene"] == "brusselator" and run["scheme"] == NAME]
        self.assertEqual({run["ending"] for run in endings}, {"refused"})
        self.assertIn("solves relaxation", endings[0]["detail"])

    def test_stands_beside_ours(self):
        chosen = fdebench("choose", "relaxation", "--error", "5e-2", "--results", self.results)
        self.assertRegex(chosen.stdout, rf"(?m)^{NAME} +\d+ ")
        self.assertRegex(chosen.stdout, rf"(?m)^{SCHEME} +\d+ ")
        reported = fdebench("report", self.results, "--out", self.folder.name)
        if "no charts" in reported.stderr:
            self.skipTest("a build without charts")
        self.assertEqual(reported.returncode, 0, reported.stderr)
        page = (Path(self.folder.name) / "index.html").read_text()
        data = data_of(page)
        self.assertCountEqual(data["lines"], [SCHEME, NAME])  # by cells won, which depends on times
        runs = next(section["runs"] for section in data["sections"] if section["id"] == "scene-relaxation")
        self.assertEqual(runs["line"].count(runs["lines"].index(NAME)), 4)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
