#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""page_alone.py FDEBENCH PAGE_ALONE: the page is a function of its results file. PAGE_ALONE makes pages and aborts where it
computes anything."""

import json
import os
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "support"))
from page_data import data_of  # noqa: E402

ROOT = Path(__file__).resolve().parents[2]
PROGRAM, PAGE_ALONE = (Path(word).resolve() for word in sys.argv[1:3])
CONSTRAINED = "fractional_constraint_2d:alpha=0.3"
SWEEPS = [
    ["--scene", "relaxation", "--scene", "pendulum", "--scene", f"{ROOT}/docs/examples/falling.toml", "--scene", CONSTRAINED,
     "--scene", f"{CONSTRAINED},formulation=acceleration", "--steps", "32,64,128", "--accuracy", "1e-3"],
    ["--scene", "stiff_relaxation", "--steps", "4096"],
]  # fmt: skip


def run(*words, **how):
    return subprocess.run([str(word) for word in words], capture_output=True, text=True, **how)


class Page(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        temporary = tempfile.TemporaryDirectory()
        cls.addClassCleanup(temporary.cleanup)
        cls.folder = Path(temporary.name)
        cls.file = cls.folder / "results.jsonl"
        for words in SWEEPS:
            made = run(PROGRAM, "run", *words, "--scheme", "l1", "--scheme", "product_trapezoidal", "--scheme", "radau_exponentials",
                       "--repeat", 1, "--out", cls.file)  # fmt: skip
            assert made.returncode == 0, made.stderr

    def page(self, name, program=(PROGRAM, "report"), file=None, **how):
        out = self.folder / name
        words = [*program, file or self.file, *(["--out"] if len(program) > 1 else []), out]
        made = run(*words, **how)
        if "no charts" in made.stderr:
            self.skipTest("a build without charts")
        self.assertEqual(made.returncode, 0, made.stderr)
        return (out / "index.html").read_bytes()

    def test_needs_no_scene_reference_clock_or_environment(self):
        self.assertEqual(self.page("alone", (PAGE_ALONE,)), self.page("own"))

    def test_has_the_same_bytes_anywhere_at_any_time(self):
        first = self.page("first")
        elsewhere = self.folder / "elsewhere"
        elsewhere.mkdir()
        places = {"HOME": str(elsewhere), "FDEBENCH_CACHE": "", "LC_ALL": "de_DE.UTF-8", "TZ": "Asia/Tokyo"}
        time.sleep(1.1)
        self.assertEqual(self.page("second", cwd=elsewhere, env={**os.environ, **places}), first)
        self.assertEqual(list(elsewhere.iterdir()), [], "nothing is computed, so nothing is kept")

    def test_shows_what_is_recorded(self):
        sections = {section["id"]: section for section in data_of(self.page("shown").decode())["sections"]}
        lines = [json.loads(line) for line in self.file.read_text().splitlines()]
        for scene in (line["scene"] for line in lines if isinstance(line.get("scene"), dict)):
            settings = ",".join(f"{name}={value}" for name, value in scene.get("settings", {}).items())
            label = ":".join(filter(None, [scene["scene"], settings])) + scene.get("checksum", "")[:8]
            if scene["scene"] == "stiff_relaxation":
                self.assertEqual(scene["trial"]["kind"], "Stiff")
                self.assertIn("Stiff", json.dumps(sections["stability"]))
                continue
            solution = sections[f"scene-{label}"]["solution"]
            self.assertEqual(sections[solution["of"]]["solution"] if "of" in solution else solution, scene["solution"])
        courses = [course for line in lines for course in line.get("courses", {}).values()]
        shown = sections["drift"]["drifts"][0]["courses"]
        self.assertEqual(len(shown), 2, "the best run of each formulation")
        for course in shown:
            self.assertIn({"t": course["t"], "value": course["drift"]}, courses)


class Tomorrow(Page):
    """The same results with names that this build does not have."""

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        lines = [json.loads(line) for line in cls.file.read_text().splitlines()]
        for line in lines:
            line.pop("checksum", None)
            scene = line["scene"] if isinstance(line.get("scene"), dict) else line
            if scene.get("scene") == "relaxation":
                scene["scene"], scene["settings"] = "tomorrow", {"form": "new", "orders": [0.1, 0.2]}
                scene["news"] = "ignored"
            if line.get("scheme") == "l1":
                line["scheme"] = "better_l1"
            if "rounding" in line.get("values", {}):
                line["values"]["beauty"] = -line["values"].pop("rounding")
            if line.get("ending") == "refused":
                line["ending"] = "went_home"
        cls.file = cls.folder / "tomorrow.jsonl"
        cls.file.write_text("".join(json.dumps(line) + "\n" for line in lines))

    def test_shows_what_is_recorded(self):
        data = data_of(self.page("shown").decode())
        self.assertIn("better_l1", data["lines"])
        scene = next(section for section in data["sections"] if section["id"] == "scene-tomorrow:form=new,orders=0.1,0.2")
        self.assertEqual(scene["equations"], [{"left": "D(y, gamma)", "right": "lambda*y"}])
        self.assertIn("better_l1", scene["runs"]["lines"])
        self.assertIn("solution", scene)
        self.assertIn("went_home", json.dumps(data))

    def test_is_read_by_every_command(self):
        scene, merged, figure = "tomorrow:form=new,orders=0.1,0.2", self.folder / "merged.jsonl", self.folder / "figure.vl.json"
        for words, said in [
            (["choose", scene, "--error", "0.1", "--results", self.file], f"{scene} "),
            (["compare", self.file, self.file], "0 only in the first"),
            (["merge", self.file, "--out", merged], "2 sessions"),
            (["plot", scene, "--results", self.file, "--kind", "work-precision", "--out", figure], str(figure)),
            (["plot", CONSTRAINED, "--results", self.file, "--kind", "drift-over-time", "--out", figure], str(figure)),
            (["plot", CONSTRAINED, "--results", self.file, "--kind", "drift", "--scheme", "better_l1", "--out", figure], str(figure)),
        ]:  # fmt: skip
            with self.subTest(words=words):
                answer = run(PROGRAM, *words)
                self.assertEqual((answer.returncode, answer.stderr), (0, ""))
                self.assertIn(said, answer.stdout)
        lines, others = ([json.loads(line) for line in file.read_text().splitlines()] for file in (merged, self.file))
        self.assertEqual(lines, others)

    def test_is_not_mistaken(self):
        answer = run(PROGRAM, "choose", "tomorow", "--error", "0.1", "--results", self.file)
        self.assertEqual(answer.returncode, 2)
        self.assertIn("no such scene", answer.stderr)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
