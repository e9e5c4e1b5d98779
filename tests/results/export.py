#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""export.py FDEBENCH: the tables of `export` hold every value of a results file, and nothing half is written."""

import copy
import csv
import json
import os
import resource
import shutil
import signal
import sqlite3
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "benchmarks" / "programs" / "records"))
from recorded_runs import joined, runs_in  # noqa: E402

PROGRAM = sys.argv.pop(1)
TABLES = ("sessions", "scenes", "parameters", "runs", "results", "courses")
SETUP = ("scheme", "external", "steps", "h", "accuracy_relative", "accuracy_absolute", "grading", "history", "tolerance", "budget")


def fdebench(*words, **options):
    return subprocess.run([PROGRAM, *map(str, words)], capture_output=True, text=True, **options)


def setup_of(run):
    """The columns SETUP of a run of the results file."""
    accuracy, grid, ours = run.get("accuracy", {}), run.get("grid", "uniform"), "external" not in run
    grading = 1.0 if grid == "uniform" else float(grid.removeprefix("graded:"))
    return (run["scheme"], int(not ours), run["steps"], run["end"] / run["steps"] if run["steps"] else 0.0, accuracy.get("relative"),
            accuracy.get("absolute"), grading, run.get("history", "auto") if ours else None, run.get("tolerance", 1e-15) if ours else None,
            run.get("budget"))  # fmt: skip


def scene_of(run):
    settings = dict(run["settings"])
    until = settings.pop("until", None)
    return (run["scene"], run.get("checksum"), until, tuple(sorted((name, json.dumps(value)) for name, value in settings.items())))


def repr_of(row):
    """Whole numbers of JSON beside those of SQL."""
    return repr([float(cell) if isinstance(cell, (int, float)) else cell for cell in row])


def from_csv(text, kind):
    return None if text == "" and not kind.startswith("TEXT NOT NULL") else float(text) if "REAL" in kind else int(text) if "INTEGER" in kind else text


class Export(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.folder = Path(cls.temporary.name)
        cls.file = cls.folder / "results.jsonl"
        sweeps = [
            ["--scene", "relaxation", "--scene", "relaxation:gamma=0.3,lambda=-100", "--scheme", "l1", "--scheme", "bdf4", "--steps", "16,32"],
            ["--scene", "multi_term:alpha=1.2,1.6,until=2", "--scene", "knife_edge:formulation=multiplier", "--steps", "32"],
            ["--scene", "relaxation", "--steps", "16", "--grid", "graded:2.5", "--history", "direct", "--tolerance", "1e-8"],
            ["--scene", "relaxation", "--accuracy", "1e-3", "--scheme", "spectral_collocation"],
            ["--scene", f"{ROOT}/docs/examples/duffing.toml:delta=0.3,until=2", "--scheme", "l1", "--steps", "16"],
            ["--scene", "relaxation", "--steps", "1", "--grid", "graded:2", "--external", 'a "quoted", name=echo \'# code: "end" 2.0\nt,y\n0,1\n1,0.43\' #'],
        ]
        for words in sweeps:
            run = fdebench("run", *words, "--repeat", 1, "--out", cls.file, env={**os.environ, "FDEBENCH_NODE": "node λ"} if words is sweeps[0] else None)
            assert run.returncode == 0, run.stderr
        cls.lines = [json.loads(line) for line in cls.file.read_text().splitlines()]
        cls.runs = runs_in(cls.file)
        for kind in ("sqlite", "csv"):
            made = fdebench("export", cls.file, "--to", kind, "--out", cls.folder / kind)
            assert made.returncode == 0, made.stderr
            assert made.stdout.startswith(f"{cls.folder / kind}\n6 sessions, "), made.stdout
        cls.database = sqlite3.connect(cls.folder / "sqlite")

    @classmethod
    def tearDownClass(cls):
        cls.database.close()
        cls.temporary.cleanup()

    def test_flat_table_has_a_row_a_run(self):
        out = self.folder / "flat.csv"
        made = fdebench("export", self.file, "--to", "flat", "--out", out)
        self.assertEqual(made.returncode, 0, made.stderr)
        with out.open(newline="") as text:
            rows = list(csv.DictReader(text))
        query = "SELECT scheme, steps, ended_at IS NOT NULL, value FROM runs LEFT JOIN results USING (run_id) WHERE latest AND quantity = 'error_end'"
        self.assertEqual(sorted((row["scheme"], int(row["steps"]), 1, float(row["error_end"])) for row in rows if row["error_end"]),
                         sorted(self.database.execute(query)))
        self.assertEqual(len(rows), self.database.execute("SELECT count(*) FROM runs WHERE latest").fetchone()[0])
        gammas = {row["gamma"] for row in rows if row["scene"] == "relaxation"}
        self.assertEqual(gammas, {"0.5", "0.3"})  # a default, and one that is set
        # With steps it refuses.
        self.assertEqual({row["accuracy"] for row in rows if row["scheme"] == "spectral_collocation"}, {"", "0.001"})
        self.assertEqual(fdebench("export", self.file, "--to", "flat", "--out", out).returncode, 2)
        out.unlink()

    def left(self):
        return sorted(path.name for path in self.folder.iterdir())

    def test_database_holds_every_value(self):
        query = self.database.execute
        self.assertEqual(query("PRAGMA integrity_check").fetchall(), [("ok",)])
        self.assertEqual(query("PRAGMA foreign_key_check").fetchall(), [])
        sessions = [line["session"] for line in self.lines if "session" in line]
        fields = ("date", "machine", "cores", "system", "compiler", "flags", "commit", "version", "node")
        columns = ", ".join(fields).replace("commit", "revision")
        self.assertEqual(query(f"SELECT {columns} FROM sessions ORDER BY session_id").fetchall(),
                         [tuple(session.get(field) for field in fields) for session in sessions])  # fmt: skip
        given = {}
        for scene, name, number, word in query("SELECT scene_id, parameter, number, word FROM parameters WHERE given"):
            value = number if number is not None else json.loads(word) if word.startswith("[") else word
            given.setdefault(scene, []).append((name, json.dumps(value)))
        scenes = {scene: (name, checksum, until, tuple(sorted(given.get(scene, [])))) for scene, name, checksum, until in
                  query("SELECT scene_id, scene, checksum, until FROM scenes")}  # fmt: skip
        columns = f"scene_id, {', '.join(SETUP)}"
        stored, courses = [], {}
        for result, t, value in query("SELECT result_id, t, value FROM courses ORDER BY rowid"):
            courses.setdefault(result, []).append((t, value))
        for scene, *setup, session, result, quantity, value, unit, wall in query(
                f"SELECT {columns}, results.session_id, result_id, quantity, value, unit, wall_clock FROM results JOIN runs USING (run_id)"):
            stored.append((session, scenes[scene], tuple(setup), quantity, value, unit, wall, tuple(courses.get(result, []))))
        for scene, *setup, session, ending, detail, ended_at in query(f"SELECT {columns}, session_id, ending, detail, ended_at FROM runs"):
            stored.append((session, scenes[scene], tuple(setup), ending, detail, ended_at))
        units = {"mescd": "digits", "history_bytes": "B", "rounding_from": "t", "frequency": "Hz"}
        written, session = [], -1
        for line in joined(copy.deepcopy(self.lines)):
            session += "session" in line
            if "ending" not in line:
                continue
            run = {"settings": {}, **line}
            of = (session, scene_of(run), setup_of(run))
            written.append((*of, run["ending"], run.get("detail"), run.get("ended_at", run["end"])))
            for part in ("values", "time"):
                for name, value in run.get(part, {}).items():
                    course = run.get("courses", {}).get(name, {"t": [], "value": []})
                    unit = "s" if name.startswith("time_") else units.get(name, "")
                    written.append((*of, name, value, unit, int(part == "time" and "wall_clock" in run), tuple(zip(course["t"], course["value"]))))
        self.assertEqual(sorted(stored, key=repr_of), sorted(written, key=repr_of))
        self.assertTrue(any(row[-1] for row in written if len(row) == 8), "no course in the sweep")
        described = [json.loads(text)["scene"] for (text,) in query("SELECT description FROM scenes WHERE description IS NOT NULL")]
        self.assertEqual(sorted(map(repr, described)), sorted({repr(line["scene"]) for line in self.lines if isinstance(line.get("scene"), dict)}))

    def test_defaults_are_parameters_too(self):
        found = self.database.execute("SELECT number, given FROM parameters JOIN scenes USING (scene_id) WHERE scene = 'relaxation' AND parameter = 'gamma'")
        self.assertEqual(sorted(found), [(0.3, 1), (0.5, 0)])

    def test_programs_are_what_they_say(self):
        found = self.database.execute("SELECT code, code_version, language FROM runs WHERE external")
        self.assertEqual(found.fetchall(), [('"end"', "2.0", None)])

    def test_view_joins_everything(self):
        (count,) = self.database.execute("SELECT count(*) FROM measurements").fetchone()
        self.assertEqual(count, sum(len(run["values"]) + len(run["time"]) for run in self.runs))

    def test_files_hold_what_the_database_holds(self):
        for table in TABLES:
            kinds = {name: f"{kind}{' NOT NULL' * strict}" for _, name, kind, strict, _, _ in self.database.execute(f"PRAGMA table_info({table})")}
            data = (self.folder / "csv" / f"{table}.csv").read_bytes()
            self.assertEqual(data.count(b"\r\n"), data.count(b"\n"))
            names, *rows = csv.reader(data.decode().splitlines(keepends=True))
            self.assertEqual(names, list(kinds))
            read = [tuple(from_csv(text, kinds[name]) for name, text in zip(names, row)) for row in rows]
            self.assertEqual(read, self.database.execute(f"SELECT * FROM {table} ORDER BY rowid").fetchall())

    def test_latest_is_what_compare_takes(self):
        """A run that another session made again counts once."""
        again, out = self.folder / "again.jsonl", self.folder / "again.sqlite"
        lines = self.file.read_text().splitlines(keepends=True)
        first = next(line for line in lines if '"session"' in line)
        other = first.replace('"machine":"', '"machine":"another ')
        of_first = lines[1 : [i for i, line in enumerate(lines) if '"session"' in line][1]]
        again.write_text("".join([*lines, other, *of_first]))
        self.assertEqual(fdebench("export", again, "--to", "sqlite", "--out", out).returncode, 0)
        database = sqlite3.connect(out)
        runs, latest = database.execute("SELECT count(*), sum(latest) FROM runs").fetchone()
        known = [json.dumps([scene_of(run), setup_of(run)]) for run in self.runs]
        self.assertEqual(latest, len(set(known)))
        self.assertEqual(runs, len(known) + sum('"ending"' in line for line in of_first))
        sessions = database.execute("SELECT DISTINCT session_id FROM runs WHERE latest ORDER BY session_id").fetchall()
        self.assertEqual(sessions, [(1,), (2,), (3,), (4,), (5,), (6,)])
        database.close()
        again.unlink()
        out.unlink()

    def test_same_file_same_bytes(self):
        self.assertEqual(fdebench("export", self.file, "--to", "csv", "--out", self.folder / "twice").returncode, 0)
        for table in TABLES:
            name = f"{table}.csv"
            self.assertEqual((self.folder / "twice" / name).read_bytes(), (self.folder / "csv" / name).read_bytes())
            (self.folder / "twice" / name).unlink()
        (self.folder / "twice").rmdir()

    def test_order_of_fields_says_nothing(self):
        reversed_fields, out = self.folder / "reversed.jsonl", self.folder / "reversed"
        reversed_fields.write_text("".join(json.dumps(dict(reversed(line.items()))) + "\n" for line in self.lines))
        self.assertEqual(fdebench("export", reversed_fields, "--to", "csv", "--out", out).returncode, 0)
        for table in TABLES:
            same, file = (self.folder / "csv" / f"{table}.csv").read_bytes(), out / f"{table}.csv"
            if table != "scenes":  # which holds the lines as they are written
                self.assertEqual(file.read_bytes(), same, table)
        shutil.rmtree(out)
        reversed_fields.unlink()

    def refused(self, said, *words, **options):
        before = self.left()
        ended = fdebench("export", *words, **options)
        self.assertEqual(ended.returncode, 2, ended.stderr)
        self.assertEqual(ended.stderr, f"fdebench: {said}\n")
        self.assertEqual(ended.stdout, "")
        self.assertEqual(self.left(), before)

    def test_bad_input_is_refused(self):
        broken, new = self.folder / "broken.jsonl", self.folder / "new"
        broken.write_text(self.file.read_text() + "{}\n")
        ended = fdebench("export", broken, "--to", "csv", "--out", new)
        self.assertEqual(ended.returncode, 0, ended.stderr)
        self.assertEqual(ended.stderr, f"fdebench: warning: {broken}: line {len(self.lines) + 1} is not a row of fdebench results (left out)\n")
        for table in TABLES:
            self.assertEqual((new / f"{table}.csv").read_bytes(), (self.folder / "csv" / f"{table}.csv").read_bytes())
        shutil.rmtree(new)
        for kind in ("sqlite", "csv"):
            self.refused(f"{self.folder / kind}: exists, it must be a new file or folder", self.file, "--to", kind, "--out", self.folder / kind)
            self.refused(f"{self.folder}/no/new: cannot be written: No such file or directory", self.file, "--to", kind, "--out", self.folder / "no" / "new")
        self.refused("--to = xml: must be sqlite, csv or flat", self.file, "--to", "xml", "--out", new)
        broken.unlink()

    def test_full_disk_leaves_nothing(self):
        def full():
            signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
            resource.setrlimit(resource.RLIMIT_FSIZE, (20000, 20000))

        new = self.folder / "new"
        for kind, said in (("sqlite", "disk I/O error"), ("csv", "File too large")):
            self.refused(f"{new}: cannot be written: {said}", self.file, "--to", kind, "--out", new, preexec_fn=full)

    def test_signal_leaves_nothing_under_the_name(self):
        """What a killed export leaves beside the name goes with the next one."""
        large, new = self.folder / "large.jsonl", self.folder / "new"
        lines = self.file.read_text().splitlines(keepends=True)
        large.write_text(lines[0] + "".join(line for line in lines if '"session"' not in line) * 40)
        for kind in ("sqlite", "csv"):
            with subprocess.Popen([PROGRAM, "export", large, "--to", kind, "--out", new], stdout=subprocess.DEVNULL) as process:
                while process.poll() is None and not list(self.folder.glob("new.*.tmp")):
                    time.sleep(0.001)
                process.kill()
            self.assertEqual(process.returncode, -signal.SIGKILL)
            self.assertFalse(new.exists())
            self.assertEqual(fdebench("export", self.file, "--to", "csv", "--out", new).returncode, 0)
            self.assertEqual(list(self.folder.glob("new.*.tmp")), [])
            for file in new.iterdir():
                file.unlink()
            new.rmdir()
        large.unlink()


if __name__ == "__main__":
    unittest.main()
