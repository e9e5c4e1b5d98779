#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""browser_test.py FDEBENCH FOLDER: makes small pages in FOLDER.
browser_test.py FDEBENCH FOLDER PART...: tries them by each PART.test.js in Debian's Chromium, where possible the one without a window,
which takes less time.
Exit code 77, for skipped, where Chromium, node or the packages of this folder are missing; ./setup.sh --tests installs them."""

import json
import os
import shutil
import subprocess
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
PROGRAM, FOLDER, PARTS = sys.argv[1], Path(sys.argv[2]).resolve(), sys.argv[3:]
CHROMIUM = next(filter(None, map(shutil.which, ("chromium-headless-shell", "chromium", "chromium-browser"))), None)
RESULTS, SCREENSHOTS = FOLDER / "results.jsonl", FOLDER / "screenshots"
SKIPPED = 77

# A second or two: closed forms and small references, of each kind of section one.
SCHEMES = ["adams_pc", "l1", "product_trapezoidal", "bdf4", "spectral_collocation"]
SWEEPS = [
    ["relaxation:gamma=0.3", "relaxation", "relaxation:gamma=0.8", "pendulum", "loxodrome"],
    ["relaxation:gamma=0.05", "stiff_relaxation"],  # trials
]


def fdebench(*words):
    subprocess.run([PROGRAM, *map(str, words)], check=True, stdout=subprocess.DEVNULL)


def results():
    for scenes, steps in zip(SWEEPS, [["--steps", "64,128,256,512,1024", "--accuracy", "1e-3,1e-6,1e-9"], ["--steps", "4096"]]):
        named = [word for kind, ids in (("--scene", scenes), ("--scheme", SCHEMES)) for id in ids for word in (kind, id)]
        fdebench("run", *named, *steps, "--repeat", 1, "--out", RESULTS)


def family():
    """Twenty scenes on a lattice of two parameters."""
    file = FOLDER / "family.jsonl"
    scenes = [f"power:gamma={gamma},p={p}" for gamma in (0.2, 0.4, 0.6, 0.8) for p in (1, 1.5, 2, 2.5, 3)]
    named = [word for kind, ids in (("--scene", scenes), ("--scheme", ["l1", "bdf2", "product_trapezoidal"])) for id in ids for word in (kind, id)]
    fdebench("run", *named, "--steps", "8,32,128,512", "--repeat", 3, "--out", file)
    fdebench("report", file, "--out", FOLDER / "family")


def earlier():
    """Results of another machine before those: l1 had half of the error on the pendulum, bdf4 failed on relaxation."""
    before = FOLDER / "before.jsonl"
    with before.open("w") as lines:
        for line in map(json.loads, RESULTS.read_text().splitlines()):
            if "session" in line:
                line["session"]["machine"] = "an older machine"
            elif line["scene"] == "pendulum" and line["scheme"] == "l1" and "values" in line:
                line["values"].update({name: value / 2 for name, value in line["values"].items() if name.startswith("error_")})
            elif line["scene"] == "relaxation" and "settings" not in line and line["scheme"] == "bdf4" and "ending" in line:
                line.update(ending="not_finite", ended_at=0.5, detail="at step 32, t = 0.5")
            lines.write(json.dumps(line) + "\n")
    return before


def make_pages():
    shutil.rmtree(FOLDER, ignore_errors=True)
    SCREENSHOTS.mkdir(parents=True)
    results()
    fdebench("report", RESULTS, "--out", FOLDER)
    family()
    before = earlier()
    fdebench("report", before, RESULTS, "--out", FOLDER / "compared")
    both = FOLDER / "both.jsonl"
    fdebench("merge", before, RESULTS, "--out", both)
    fdebench("report", both, "--out", FOLDER / "machines")


def run(parts):
    of_tests = {"PROGRAM": PROGRAM, "CHROMIUM": CHROMIUM, "PAGE": FOLDER / "index.html", "RESULTS": RESULTS, "SCREENSHOTS": SCREENSHOTS}
    environment = {**os.environ, **{name: str(value) for name, value in of_tests.items()}}
    os.execvpe("node", ["node", str(HERE / "parts.js"), *parts], environment)


missing = [name for name, there in [
    ("chromium", CHROMIUM), ("node", shutil.which("node")), ("the packages of tests/browser", (HERE / "node_modules" / ".package-lock.json").exists()),
] if not there]  # fmt: skip
if missing:
    print(f"skipped without {', '.join(missing)}: ./setup.sh --tests installs them")
    sys.exit(SKIPPED)
if PARTS:
    run(PARTS)
else:
    make_pages()
