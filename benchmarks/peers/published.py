#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Recomputes published figures (published.toml) with the schemes of fdebench of the same rules: published.py FDEBENCH [times].

Prints the published errors, those of fdebench, and the digits in which they agree; with `times` the seconds that MATLAB took
and those that the same code takes here in GNU Octave. Exit code 1 if errors differ by more than the tolerance of Newton's method explains.
"""

import csv
import math
import subprocess
import sys
import tempfile
import tomllib

import peers

FIGURES = tomllib.loads((peers.HERE / "published.toml").read_text())["figures"]
AS_PRINTED = 5e-9  # the start weights of flmm2 have lost the digits beyond
OF_NEWTON = 5e-3  # relative, of an error computed with Newton's tolerance 1e-6


def table(fdebench, *words):
    ran = subprocess.run([fdebench, *words], capture_output=True, text=True, check=True)
    return list(csv.DictReader(ran.stdout.splitlines()))


def error(fdebench, scene, scheme, steps):
    """The root of the sum of squares of the errors at all steps."""
    solved = table(fdebench, "solve", scene, "--scheme", scheme, "--steps", str(steps))
    exact = table(fdebench, "exact", scene, "--at", ",".join(row["t"] for row in solved))
    return math.hypot(*(float(a["y"]) - float(b["y"]) for a, b in zip(solved, exact, strict=True)))


def errors(fdebench):
    differing = 0
    for figures in FIGURES:
        print(f"\n{figures['scene']}\n{'code':22}{'scheme':24}{'N':>5}{'published':>22}{'fdebench':>22}{'relative difference':>22}")
        for row in figures["rows"]:
            allowed = OF_NEWTON if "tolerance" in row else AS_PRINTED
            for steps, published in zip(figures["steps"], row["errors"], strict=True):
                if not published:
                    continue
                ours = error(fdebench, figures["scene"], row["scheme"], steps)
                difference = abs(ours - published) / published
                differing += difference > allowed
                print(f"{row['code'] + ' ' + row.get('setting', ''):22}{row['scheme']:24}{steps:5}{published:22.12g}{ours:22.12g}{difference:22.1e}")
    return differing > 0


def times(fdebench):
    print(f"{'code':22}{'N':>5}{'MATLAB, published, ms':>24}{'Octave, here, ms':>20}{'ratio':>8}")
    for figures in FIGURES:
        for row in figures["rows"]:
            for steps, seconds in list(zip(figures["steps"], row.get("seconds", []), strict=False))[-2:]:
                with tempfile.TemporaryDirectory() as folder:
                    command = peers.command(peers.CODES[row["code"]], row.get("setting", ""))
                    subprocess.run([fdebench, "run", "--scene", figures["scene"], "--steps", str(steps), "--repeat", "1", "--external",
                                    f"octave={command}", "--out", f"{folder}/r.jsonl", "--quiet"], check=True, stdout=subprocess.DEVNULL)
                    here = peers.runs_in(f"{folder}/r.jsonl")[0]["time"]["time_minimum"]
                print(f"{row['code'] + ' ' + row.get('setting', ''):22}{steps:5}{1e3 * seconds:24.2f}{1e3 * here:20.1f}{here / seconds:8.0f}")
    return False


if __name__ == "__main__":
    sys.exit((times if sys.argv[2:] == ["times"] else errors)(sys.argv[1]))
