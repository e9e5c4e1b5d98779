#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""site_test.py FDEBENCH HEADERS FOLDER BUILD...: builds a small site in FOLDER by the command BUILD, follows its links and tries
it in Chromium. Exit code 77, for skipped, where Chromium, node or the packages of tests/browser are missing."""

import os
import shutil
import subprocess
import sys
from pathlib import Path

import links

HERE = Path(__file__).resolve().parent
PROGRAM, HEADERS, FOLDER, *BUILD = sys.argv[1:]
SITE = Path(FOLDER, "site").resolve()
RESULTS = Path(FOLDER, "results.jsonl").resolve()
SCREENSHOTS = Path(FOLDER, "screenshots").resolve()
SKIPPED = 77

RESULTS.unlink(missing_ok=True)
shutil.rmtree(SITE, ignore_errors=True)
SCREENSHOTS.mkdir(parents=True, exist_ok=True)
runs = ["--scene", "relaxation", "--scene", "pendulum", "--scheme", "l1", "--scheme", "bdf4", "--steps", "64,128,256"]
subprocess.run([PROGRAM, "run", *runs, "--out", RESULTS], check=True, stdout=subprocess.DEVNULL)
subprocess.run([*BUILD, SITE, HEADERS, RESULTS, "--quick"], check=True)
faults = list(links.faults(SITE))
print(*faults, sep="\n")
if faults:
    sys.exit(1)

chromium = next(filter(None, map(shutil.which, ("chromium-headless-shell", "chromium", "chromium-browser"))), None)
if not (chromium and shutil.which("node") and (HERE.parent / "browser/node_modules/.package-lock.json").exists()):
    print("the links are right; skipped without Chromium and node: ./setup.sh --tests installs them")
    sys.exit(SKIPPED)
of_tests = {"CHROMIUM": chromium, "SITE": str(SITE), "SCREENSHOTS": str(SCREENSHOTS)}
os.execvpe("node", ["node", "--test", str(HERE / "site.test.js")], {**os.environ, **of_tests})
