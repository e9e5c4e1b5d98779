#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""any_scene.py FDEBENCH WORD...: the program of docs/examples that takes any scene of one order has the errors of our L1 rule on scenes that it
does not know, says what it is and how long it took, and refuses what it cannot take."""

import shlex
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "benchmarks" / "programs" / "records"))
from recorded_runs import runs_in  # noqa: E402

PROGRAM, *WORDS = sys.argv[1:]
TAKEN = ("relaxation", "stiff_relaxation:lambda=-100", "brusselator:until=5", "relaxation_pair", "diethelm", "pendulum:until=5")
REFUSED = ("bagley_torvik", "linear_system", "knife_edge:formulation=multiplier")


class AnyScene(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        with tempfile.TemporaryDirectory() as folder:
            results = Path(folder) / "results.jsonl"
            scenes = [word for scene in (*TAKEN, *REFUSED) for word in ("--scene", scene)]
            run = subprocess.run([PROGRAM, "run", *scenes, "--steps", "128", "--repeat", "1", "--tolerance", "1e-12", "--scheme", "l1",
                                  "--external", f"theirs={shlex.join(WORDS)}", "--out", results], capture_output=True, text=True)  # fmt: skip
            assert run.returncode == 0, run.stderr
            cls.runs = runs_in(results)

    def values(self, quantity, scheme):
        return {run["scene"]: value for run in self.runs if run["scheme"] == scheme and (value := {**run["values"], **run["time"]}.get(quantity)) is not None}

    def test_has_the_errors_of_the_same_rule_of_ours(self):
        for error in ("error_end", "error_maximum"):
            ours, theirs = self.values(error, "l1"), self.values(error, "theirs")
            self.assertEqual(set(theirs), {scene.split(":")[0] for scene in TAKEN})
            for scene, value in theirs.items():
                self.assertAlmostEqual(value / ours[scene], 1.0, delta=1e-6, msg=scene)

    def test_says_what_it_is_and_its_times(self):
        described = [run["program"] for run in self.runs if run["scheme"] == "theirs" and run["ending"] == "finished"]
        self.assertEqual([(one["code"], one["version"]) for one in described], [("l1_system", "1.0")] * len(TAKEN))
        self.assertIn("NumPy", described[0]["language"])
        start, solve = self.values("time_start", "theirs"), self.values("time_median", "theirs")
        self.assertEqual(len(start), len(TAKEN))
        self.assertTrue(all(0.01 < start[scene] for scene in solve))  # Python and NumPy start in more than 10 ms
        self.assertEqual(self.values("time_start", "l1"), {})

    def test_refuses_the_others(self):
        endings = {run["scene"]: run["ending"] for run in self.runs if run["scheme"] == "theirs"}
        self.assertEqual([endings[scene.split(":")[0]] for scene in REFUSED], ["refused"] * len(REFUSED))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
