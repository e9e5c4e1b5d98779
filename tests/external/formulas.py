#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""formulas.py FDEBENCH SCENE_VALUES: the right-hand sides and derivatives that external programs are given, evaluated by Python, are those
of every scene that is made from formulas; the equations of several terms are the same equations."""

import json
import math
import subprocess
import sys
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PROGRAM, VALUES = sys.argv[1:]
IN_CPP = {"multi_term", "fractional_constraint_1d", "fractional_extremum", "two_sided_constraint", "fractional_hamilton", "fractional_vakonomic",
          "fractional_diffusion", "fractional_diffusion_2d", "fractional_allen_cahn"}  # fmt: skip
WITH_TABLE = {str(ROOT / "docs/examples/measured_load.toml")}
TOO_LONG = {"blade_on_sphere", str(ROOT / "docs/examples/sleigh.toml")}  # in the formulation that is their default


def mittag_leffler(alpha, beta, z):
    return sum(z**k / math.gamma(alpha * k + beta) for k in range(100))


FUNCTIONS = {name: getattr(math, name) for name in "sin cos tan asin acos atan sinh cosh tanh exp log sqrt gamma atan2".split()}
FUNCTIONS |= {"power": math.pow, "abs": abs, "min": min, "max": max, "sign": lambda x: (x > 0) - (x < 0), "step": lambda x: ((x > 0) - (x < 0) + 1) / 2}
FUNCTIONS["mittag_leffler"] = mittag_leffler


def value(text, t, y):
    return eval(text, {"__builtins__": {}}, {**FUNCTIONS, "t": t, **{f"y{i}": one for i, one in enumerate(y, 1)}})


class Formulas(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        listed = subprocess.run([PROGRAM, "scenes", "--json"], capture_output=True, text=True, check=True).stdout
        files = {scene["id"]: ROOT / "benchmarks/scenes" / f"{scene['id']}.toml" for scene in json.loads(listed)}
        files |= {str(path): path for path in sorted((ROOT / "docs/examples").glob("*.toml"))}
        # With delays a right-hand side is no function of t and y, and a task has no formulas.
        scenes = [name for name, path in files.items() if not path.exists() or "\nbefore" not in path.read_text()]
        forms = [f"{scene}:formulation={form}" for scene in ("knife_edge", "fractional_knife_edge") for form in ("acceleration", "multiplier")]
        shown = subprocess.run([VALUES, *scenes, *forms], capture_output=True, text=True)
        assert shown.returncode == 0, shown.stderr
        cls.all = [json.loads(line) for line in shown.stdout.splitlines()]
        assert len(cls.all) == len(scenes) + len(forms) > 30

    def assert_near(self, got, expected, where):
        if expected is not None and math.isfinite(expected):
            self.assertAlmostEqual(got, expected, delta=1e-11 * (1 + abs(expected)), msg=where)

    def test_rows_are_those_of_the_problem(self):
        for scene in self.all:
            task = scene["task"]
            if "system" not in task:
                continue
            system = task["system"]
            for point in scene["points"]:
                t, y = point["t"], point["y"]
                for i, text in enumerate(system["rhs"]):
                    self.assert_near(value(text, t, y), point["rhs"][i], f"{task['label']}: row {i}: {text}")
                    for j, slope in enumerate(system["jacobian"][i]):
                        self.assert_near(value(slope, t, y), point["jacobian"][i][j], f"{task['label']}: d f{i} / d y{j}: {slope}")

    def test_only_scenes_in_cpp_with_tables_and_too_long_ones_have_none(self):
        self.assertEqual({scene["task"]["scene"] for scene in self.all if "system" not in scene["task"]}, IN_CPP | WITH_TABLE | TOO_LONG)

    def test_terms_are_the_rows_of_each_chain(self):
        """sum c_k D^(a_k) x = rhs, with D^(a_k) x as the rows of the chain have it, holds where the last row does."""
        seen = 0
        for scene in self.all:
            task = scene["task"]
            for equation in task.get("multi_term", []):
                seen += 1
                first = int(equation["unknown"][1:]) - 1
                nodes, order, last = {}, 0.0, first
                while order < equation["orders"][-1] - 1e-12:
                    nodes[round(order, 12)], order, last = last, order + task["rows"][last]["order"], last + 1
                for point in scene["points"]:
                    y = point["y"]
                    left = equation["coefficients"][-1] * point["rhs"][last - 1]
                    for coefficient, of in zip(equation["coefficients"][:-1], equation["orders"][:-1]):
                        left += coefficient * y[nodes[round(of, 12)]]
                    self.assert_near(value(equation["rhs"], point["t"], y), left, f"{task['label']}: {equation}")
        self.assertGreater(seen, 15)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
