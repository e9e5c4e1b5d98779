#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""peers.py facts FDEBENCH | octave FDEBENCH OCTAVE | numpy PYTHON: the adapters of benchmarks/peers and their tables.

facts: the tables are complete, and each code that is found in FDEBENCH_PEERS solves or refuses a problem. octave and numpy: the
adapter of this language reads formulas; the one of Octave solves with tests/peers/codes, which has a stand-in of a code."""

import json
import math
import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

HERE = Path(__file__).resolve().parent
PEERS = HERE.parents[1] / "benchmarks/peers"
sys.path.insert(0, str(PEERS))
import peers  # noqa: E402

PART, *WORDS = sys.argv[1:]
T, Y = 0.5, [2.0, -3.0]
FORMULAS = {
    "((2*y1)-(-y2))": 1.0,
    "((y1*y2)/t)": -12.0,
    "(-power(y1,0.5))": -math.sqrt(2),
    "(1e-05*y2)": -3e-5,
    "(sign(0)+(sign(y2)*step(0)))": -0.5,
    "(step(y1)+step(y2))": 1.0,
    "(gamma(t)/sqrt(3.141592653589793))": 1.0,
    "atan2(y2,y1)": math.atan2(-3, 2),
    "(min(y1,y2)+max(t,y1))": -1.0,
    "(asin(t)+(acos(t)+atan(t)))": math.pi / 2 + math.atan(0.5),
    "(sinh(t)+(cosh(t)-exp(t)))": 0.0,
    "((sin(t)*cos(t))-(tanh(t)*tan(t)))": math.sin(0.5) * math.cos(0.5) - math.tanh(0.5) * math.tan(0.5),
    "(log(y1)+abs(y2))": math.log(2) + 3,
}


def endings(fdebench, scene, steps, name, command, folder):
    """The runs of this command."""
    with tempfile.TemporaryDirectory() as out:
        file = Path(out) / "results.jsonl"
        words = ["run", "--scene", scene, "--steps", steps, "--repeat", "1", "--external", f"{name}={command}", "--out", str(file), "--quiet"]
        run = subprocess.run([fdebench, *words], capture_output=True, text=True, env=os.environ | {"FDEBENCH_PEERS": str(folder)})
        assert run.returncode == 0, run.stderr
        return peers.runs_in(file)


class Facts(unittest.TestCase):
    def test_each_code_has_its_facts(self):
        for name, code in peers.CODES.items():
            with self.subTest(name):
                for fact in ("title", "authors", "get", "licence", "language", "file", "takes"):
                    self.assertTrue(code[fact])
                self.assertTrue(code["settings"])
                lines = [peers.line_name(code, setting) for setting in code["settings"]]
                self.assertEqual(len(lines), len(set(lines)))
                self.assertNotIn("=", "".join(lines))
                self.assertTrue(peers.command(code, code["settings"][0]))

    def test_fdebench_has_each_problem(self):
        for problem in peers.PROBLEMS:
            with self.subTest(problem["scene"]), tempfile.TemporaryDirectory() as out:
                words = ["run", "--scene", problem["scene"], "--steps", "16", "--repeat", "1", "--scheme", "l1", "--out", f"{out}/r.jsonl"]
                run = subprocess.run([WORDS[0], *words], capture_output=True, text=True, cwd=peers.ROOT)
                self.assertEqual(run.returncode, 0, run.stderr)

    def test_pages_have_the_tables_of_the_results(self):
        files = sorted(str(file) for file in (PEERS / "results").glob("*.jsonl"))
        for page, words in (("peers.md", ["nearest"]), ("peers_table.md", [])):
            printed = subprocess.run([sys.executable, PEERS / "table.py", *words, *files], capture_output=True, text=True, check=True).stdout
            self.assertIn(printed.strip(), (peers.ROOT / "docs" / page).read_text())

    def test_each_code_found_solves_or_refuses(self):
        for code in filter(peers.is_found, peers.CODES.values()):
            with self.subTest(code["name"]):
                setting = code["settings"][0]
                (ran,) = endings(WORDS[0], "relaxation", "16", peers.line_name(code, setting), peers.command(code, setting), peers.folder_of_codes())
                self.assertIn(ran["ending"], ("finished", "refused"))


class Octave(unittest.TestCase):
    def test_formulas(self):
        formulas = "{" + ";".join(f'"{formula}"' for formula in FORMULAS) + "}"
        script = f'addpath("{PEERS}/octave"); f = handle_of({formulas}, "y(%d)"); printf("%.17g\\n", f({T}, {Y}));'
        run = subprocess.run([WORDS[1], "--norc", "--quiet", "--no-history", "--eval", script], capture_output=True, text=True)
        check(self, run)

    def test_stand_in(self):
        command = f"{WORDS[1]} --norc --quiet --no-history {PEERS}/octave/peer.m fde12 mu 1"
        runs = endings(WORDS[0], "relaxation", "64,128", "fde12", command, HERE / "codes")
        self.assertEqual({(run["ending"], run["program"]["code"]) for run in runs}, {("finished", "fde12")})
        first, second = (run["values"]["error_end"] for run in runs)
        self.assertAlmostEqual(math.log2(first / second), 1, delta=0.2)  # a rule of order 1
        refused = endings(WORDS[0], "bagley_torvik", "16", "fde12", command, HERE / "codes")
        self.assertEqual(refused[-1]["ending"], "refused")
        self.assertIn("systems of one order", json.dumps(refused[-1]))


class Numpy(unittest.TestCase):
    def test_formulas(self):
        script = f"import peer; print(*peer.function_of({list(FORMULAS)})({T}, {Y}), sep='\\n')"
        run = subprocess.run([WORDS[0], "-c", script], capture_output=True, text=True, env=os.environ | {"PYTHONPATH": str(PEERS / "python")})
        check(self, run)


def check(test, run):
    """Each line of the output is the value of its formula."""
    test.assertEqual(run.returncode, 0, run.stderr)
    for (formula, expected), value in zip(FORMULAS.items(), run.stdout.split(), strict=True):
        with test.subTest(formula):
            test.assertAlmostEqual(float(value), expected, delta=1e-14)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], defaultTest=PART.capitalize())
