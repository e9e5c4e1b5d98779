#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""schema.py FDEBENCH: what fdebench writes is what docs/results.schema.json says; what that forbids fdebench refuses."""

import copy
import json
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import jsonschema

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "support"))
from page_data import data_of  # noqa: E402

ROOT = Path(__file__).resolve().parents[2]
SCHEMA = json.loads((ROOT / "docs" / "results.schema.json").read_text())
VALIDATOR = jsonschema.Draft202012Validator(SCHEMA)
PROGRAM = sys.argv.pop(1)


def fdebench(*words):
    return subprocess.run([PROGRAM, *map(str, words)], capture_output=True, text=True)


def each(option, *values):
    return [word for value in values for word in (option, value)]


class Results(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.file = Path(cls.folder.name) / "results.jsonl"
        runs = [
            ["--scene", "relaxation", "--scheme", "l1", "--scheme", "adams_pc", "--steps", "16,32"],
            ["--scene", "multi_term:alpha=1.2,1.6,until=2", "--scene", "knife_edge:formulation=multiplier", "--steps", "32"],
            ["--scene", "relaxation", "--steps", "16", "--grid", "graded:2.5", "--history", "direct", "--tolerance", "1e-8"],
            ["--scene", "relaxation", "--accuracy", "1e-3", "--scheme", "l1"],
            ["--scene", f"{ROOT}/docs/examples/duffing.toml:delta=0.3,until=2", "--scheme", "l1", "--steps", "16"],
            ["--scene", "relaxation", "--steps", "1", "--grid", "graded:2", "--external", "crash=kill -SEGV $$", "--external",
             "end=echo 't,y\n0,1\n1,0.43' #", "--external",
             "said=echo '# times: own\n# language: sh\n# first: 0.5\n# code: end 1.0\n# seconds: 0.1 0.2\nt,y\n1,0.43' #"],
        ]
        for words in runs:
            run = fdebench("run", *words, "--repeat", 1, "--out", cls.file)
            assert run.returncode == 0, run.stderr
        written = Path(cls.folder.name) / "written.csv"
        written.write_text("t,y\n0,1\n1,0.43\n")
        judged = fdebench("judge", "relaxation", written, "--seconds", 1, "--name", "ours λ", "--out", cls.file)
        assert judged.returncode == 0, judged.stderr
        cls.lines = [json.loads(line) for line in cls.file.read_text().splitlines()]

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def is_read(self, lines):
        """Whether fdebench takes all lines of such a file; what it says."""
        file = Path(self.folder.name) / "changed.jsonl"
        file.write_text("".join(json.dumps(line) + "\n" for line in lines))
        answer = fdebench("compare", file, file)
        self.assertIn(answer.returncode, (0, 2))
        for line in answer.stderr.splitlines():
            self.assertRegex(line, "^fdebench: (warning: )?" + re.escape(f"{file}: line ") + r"\d+")
        return answer.returncode == 0 and "left out" not in answer.stderr, answer.stderr

    def test_what_is_written_is_valid(self):
        jsonschema.Draft202012Validator.check_schema(SCHEMA)
        for line in self.lines:
            VALIDATOR.validate(line)
        self.assertEqual(sum("session" in line for line in self.lines), 7)
        fields = {"external", "accuracy", "detail", "budget", "checksum", "wall_clock", "time", "columns", "courses", "ended_at"}
        self.assertTrue(fields <= set().union(*self.lines))

    def test_measures_are_those_of_the_lists(self):
        lists = (ROOT / "benchmarks" / "measures" / "list.def").read_text()
        kinds = (ROOT / "benchmarks" / "measures" / "error_kind.hpp").read_text()
        times = set(re.findall(r'TimeMeasure{"(\w+)"', (ROOT / "benchmarks" / "measures" / "measures.cpp").read_text()))
        values = set(re.findall(r"FDE_MEASURE\((\w+)\)", lists)) | set(re.findall(r'"((?:error|baseline|unresolved)_(?:end|maximum)\w*)"', "\n".join(
            line for line in kinds.splitlines() if not line.lstrip().startswith("//"))))
        self.assertEqual(set(SCHEMA["$defs"]["values"]["properties"]), values)
        self.assertEqual(set(SCHEMA["$defs"]["time"]["properties"]), times)
        page = (ROOT / "docs" / "results.md").read_text()
        for name in values | times | set(SCHEMA["$defs"]["run"]["properties"]) | set(SCHEMA["$defs"]["key"]["properties"]):
            self.assertIn(f"`{name}`", page)

    def first(self, *fields, **values):
        """The number of the first line that has these fields, and fields with these values."""
        return next(i for i, line in enumerate(self.lines) if all(name in line for name in fields) and values.items() <= line.items())

    def changed(self, number, change):
        lines = copy.deepcopy(self.lines)
        change(lines[number])
        return lines

    def refused(self, number, change):
        lines = self.changed(number, change)
        self.assertFalse(VALIDATOR.is_valid(lines[number]))
        taken, said = self.is_read(lines)
        self.assertFalse(taken)
        self.assertIn(f": line {number + 1}", said)

    def test_what_the_schema_forbids_is_refused_with_its_line(self):
        run, external, of_file = self.first("values", "columns"), self.first("ending", "external"), self.first("ending", "checksum")
        times, scene, program = self.first("time"), next(i for i, line in enumerate(self.lines) if isinstance(line.get("scene"), dict)), self.first("program")
        changes = [
            (run, {"values": {"error_end": -1.0}}), (run, {"values": {"error_end": None}}), (run, {"values": {"error_end": "1"}}), (run, {"values": {"": 1.0}}),
            (run, {"values": [1.0]}), (run, {"steps": 0}), (run, {"steps": 2.5}), (run, {"steps": 2**31}), (run, {"end": -1.0}), (run, {"ended_at": -1.0}),
            (run, {"tolerance": 2.0}), (run, {"budget": 0.0}), (run, {"grid": "curved"}), (run, {"history": "none"}), (run, {"scene": ""}),
            (run, {"scheme": ""}), (run, {"ending": ""}), (run, {"settings": {"until": 0.0}}), (run, {"settings": 1}), (run, {"settings": {"": 1.0}}),
            (external, {"scheme": "a\nb"}), (external, {"scheme": ""}), (external, {"scheme": "x" * 101}),
            (of_file, {"checksum": ""}), (of_file, {"checksum": "abc"}), (of_file, {"checksum": "Z" * 64}), (of_file, {"checksum": 1}),
            (of_file, {"settings": {"B": [None]}}), (run, {"courses": {"drift_internal": {"t": [1.0]}}}),
            (run, {"courses": {"drift_internal": {"t": [-1.0], "value": [1.0]}}}), (run, {"wall_clock": True}), (run, {"columns": {"names": ["a\nb"]}}),
            (run, {"columns": {"names": ["x"], "errors": [[1.0]]}}), (run, {"columns": {"names": ["x"], "errors": [[-1.0]] * 8}}),
            (run, {"program": {"code": "a", "version": "", "language": ""}}), (times, {"time": {"time_median": -1.0}}), (times, {"scheme": ""}), (times, {"wall_clock": True}),
        ]  # fmt: skip
        for number, change in changes:
            with self.subTest(change=change):
                self.refused(number, lambda line, change=change: line.update(change))
        for change in ({"title": None}, {"title": "a\nb"}, {"settings": 1}, {"scene": ""}, {"reference_seconds": -1.0}, {"evidence": 1},
                       {"trial": {}}, {"solution": {}}, {"equations": [{"left": "y"}]}, {"parameters": [{"name": ""}]},
                       {"solution": {"t": [], "columns": ["y"], "values": [[]], "bound": 0.0}},
                       {"solution": {"t": [0.0], "columns": [], "values": [], "bound": 0.0}},
                       {"solution": {"t": [0.0], "columns": ["y"], "values": [[1.0]], "bound": 0.0, "motion": {"columns": ["y"]}}}):  # fmt: skip
            with self.subTest(change=change):
                self.refused(scene, lambda line, change=change: line["scene"].update(change))
        for change in ({"code": "a\nb"}, {"code": "x" * 101}, {"version": 1}, {"language": "\x7f"}):
            with self.subTest(change=change):
                self.refused(program, lambda line, change=change: line["program"].update(change))
        for field in ("scene", "scheme", "steps", "end", "ending"):
            with self.subTest(without=field):
                self.refused(run, lambda line, field=field: line.pop(field))
        self.refused(times, lambda line: line.pop("time"))
        self.assertTrue(self.is_read(self.lines)[0])

    def test_what_is_not_in_one_line_is_refused_too(self):
        """The name of one of our schemes for another program; times that do not increase; lists of other lengths; no session."""
        run = self.first("values", "columns")
        count = len(self.lines[run]["columns"]["names"])
        for change, said in [
            ({"courses": {"drift_internal": {"t": [1.0, 1.0], "value": [0.0, 0.0]}}}, "must increase"),
            ({"courses": {"drift_internal": {"t": [1.0], "value": []}}}, "0 values at 1 times"),
            ({"columns": {"names": ["x"] * count, "errors": [[0.0] * (count + 1)] * 8}}, f"{count + 1} values"),
            ({"external": True}, "another name than those of our schemes"),
        ]:  # fmt: skip
            with self.subTest(change=change):
                taken, why = self.is_read(self.changed(run, lambda line, change=change: line.update(change)))
                self.assertFalse(taken)
                self.assertIn(said, why)
        taken, why = self.is_read(self.lines[1:])
        self.assertFalse(taken)
        self.assertIn("line 1: a scene before the first session", why)

    def test_programs_say_what_they_are(self):
        described = {line["scheme"]: line["program"] for line in self.lines if "program" in line}
        self.assertEqual(described, {"said": {"code": "end", "version": "1.0", "language": "sh"}})
        self.assertEqual({line["scheme"] for line in self.lines if "time_start" in line.get("time", {})}, {"said"})

    def test_what_another_version_may_say_is_read(self):
        names = {"scene": "tomorrow", "scheme": "better_l1", "ending": "went_home"}
        lines = copy.deepcopy(self.lines)
        for line in lines:
            if "session" in line:
                continue
            of = line["scene"] if isinstance(line["scene"], dict) else line
            of.update({name: value for name, value in names.items() if of.get(name) in ("relaxation", "l1", "finished")})
            of.setdefault("settings", {})["news"] = [1.0, 2.0]
            if "rounding" in of.get("values", {}):
                of["values"]["beauty"] = -of["values"].pop("rounding")
            VALIDATOR.validate(line)
        self.assertEqual(self.is_read(lines), (True, ""))


class Page(unittest.TestCase):
    """What the page holds is what docs/page.schema.json says, and all of it."""

    SCHEMA = json.loads((ROOT / "docs" / "page.schema.json").read_text())

    def test_is_what_the_schema_says(self):
        with tempfile.TemporaryDirectory() as folder:
            file, constrained = Path(folder) / "results.jsonl", "fractional_constraint_2d:alpha=0.3"
            few = each("--scheme", "l1", "product_trapezoidal", "spectral_collocation")
            sweeps = [
                [*each("--scene", "relaxation:gamma=0.3", "relaxation", "relaxation:gamma=0.8", "pendulum", "pendulum:beta=0"), *few,
                 *each("--scheme", "decoupled_multi_order", "commensurate_adams_pc"), "--steps", "64,128,256", "--accuracy", "1e-3,1e-6"],
                [*each("--scene", constrained, f"{constrained},formulation=multiplier", f"{constrained},formulation=acceleration", "loxodrome"),
                 *few, "--steps", "32,64,128"],
                ["--scene", "relaxation:gamma=0.05", "--scheme", "l1", "--steps", 4096],  # a trial
                ["--scene", "relaxation:lambda=0", "--scheme", "l1", "--steps", 32],  # without error
                [*each("--scene", *(f"power:gamma={gamma},p={p}" for gamma in (0.2, 0.4, 0.6, 0.8) for p in (1, 1.5, 2, 2.5, 3))),
                 *each("--scheme", "l1", "bdf2"), "--steps", "32,128"],
                ["--scene", "relaxation", "--steps", 1, "--external", "end=echo '# language: GNU Octave 7.3.0\nt,y\n0,1\n1,0.43' #"],  # the whole process is timed
                ["--scene", "relaxation_pair", "--scheme", "l1", "--steps", 64],
                ["--scene", "relaxation_pair", "--steps", 1, "--external", "part=echo 't,x\n0,1\n5,0.01' #"],  # one column of two
            ]  # fmt: skip
            for words in sweeps:
                run = fdebench("run", *words, "--repeat", 1, "--out", file)
                self.assertEqual(run.returncode, 0, run.stderr)
            self.assertEqual(fdebench("report", file, file, "--runs", "1", "--out", folder).returncode, 0)
            page = (Path(folder) / "index.html").read_text()
        data = data_of(page)
        jsonschema.Draft202012Validator.check_schema(self.SCHEMA)
        jsonschema.Draft202012Validator(self.SCHEMA).validate(data)
        held = {name for section in data["sections"] for name in section}
        self.assertEqual(set(self.SCHEMA["$defs"]["section"]["properties"]) - held, set(), "what the test does not see")


if __name__ == "__main__":
    unittest.main()
